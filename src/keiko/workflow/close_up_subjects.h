#pragma once

#include "keiko/report/content/report.h"
#include "keiko/scene/camera.h"
#include "keiko/workflow/open_scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// Subject of a close-up, and the view that shows it.
struct CloseUpSubject {
    CloseUp::Of of = CloseUp::Of::seam; ///< kind of the finding
    std::uint32_t index = 0;            ///< as CloseUp::index
    Vec3 place{0};                      ///< world, mm
    Camera view;                        ///< that shows the place most squarely
};

/// The faults of the first screen, then the worst seams, faces and crossings in turn, `most` at
/// most. Those that neither the views nor the standing views show are left out.
std::vector<CloseUpSubject> close_up_subjects(const Scene& scene, const Report& report,
                                              std::span<const NamedView> views, std::size_t most);

} // namespace keiko
