#pragma once

#include "keiko/api/scene.h"
#include "keiko/viewer/viewed_scene.h"

#include "tests/support/paths.h"

#include <filesystem>
#include <memory>
#include <span>

namespace keiko::viewer::test {

/// A camera of few pixels before the hood.
inline Camera small_camera() {
    return {.eye = {-2000, -1500, 1800}, .target = {560, 0, 720}, .width = 48, .height = 27};
}

/// A rig of one row of lamps above the hood.
inline LightRig one_row() {
    LightRig rig;
    rig.sources.emplace_back(
        CPlane{.origin = {-3000, -2000, 3000}, .u = {6000, 0, 0}, .v = {0, 4000, 0}, .lamps = 10});
    return rig;
}

/// The hood of `surfaces`.
inline Scene hood_scene(const SceneOptions& options = {}) {
    const std::filesystem::path inputs[] = {keiko::test::repository("surfaces/hood.step")};
    return open_scene(inputs, options);
}

/// The hood of `surfaces` as `keiko view` has it.
inline std::unique_ptr<ViewedScene> viewed_hood(CheckOptions check = {},
                                                const SceneOptions& options = {}) {
    return std::make_unique<ViewedScene>(hood_scene(options), NamedView{"small", small_camera(), 0},
                                         one_row(), std::move(check));
}

} // namespace keiko::viewer::test
