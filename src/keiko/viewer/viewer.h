#pragma once

#include "keiko/api/check.h"
#include "keiko/api/view.h"
#include "keiko/base/job.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace keiko::viewer {

/// Options of show.
struct ViewerOptions {
    int port = 0;                         ///< on 127.0.0.1; 0: one that is free
    CheckOptions check{};                 ///< how the geometry is judged once a page asks
    std::optional<ReportFolder> report{}; ///< whose findings are shown instead
    std::filesystem::path solution{};     ///< that the scene's reflected light is of; empty: none
};

/// Scenes of a viewer.
struct ShownScenes {
    Scene scene;                    ///< the one that is judged
    std::optional<Scene> against{}; ///< an earlier revision of it
};

/// Shows a scene to pages on this machine until the job is to stop. `ready` gets the address to
/// open, with the token in its fragment, as soon as requests are answered. Throws FieldError for a
/// port that is taken, and Cancelled at the end.
void show(ShownScenes scenes, const NamedView& view, LightRig rig, const ViewerOptions& options,
          const std::function<void(const std::string& address)>& ready, const Job& job);

} // namespace keiko::viewer
