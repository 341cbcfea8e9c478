#pragma once

#include "keiko/base/job.h"
#include "keiko/render/caustics/light_chart.h"
#include "keiko/render/caustics/light_path.h"

#include <array>
#include <vector>

namespace keiko {

/// Light between three neighbouring rays of a light, where it lands on a surface.
struct Beam {
    std::uint32_t instance = 0, face = 0;                   ///< of the surface
    LightWay way{};                                         ///< to it
    std::array<Vec3, 3> corners{Vec3(0), Vec3(0), Vec3(0)}; ///< landings, mm
    std::array<Vec2, 3> at{Vec2(0), Vec2(0), Vec2(0)};      ///< coordinates of their rays
    std::array<double, 3> density{}; ///< of the light at the corners, relative to each other
    Vec3 normal{0}, direction{0};    ///< unit: of the surface towards the light, and of the light
    Rgb flux{};                      ///< lm that arrive
};

/// Beams of the rays of a chart. A grid of rays is followed to where they land; three neighbours
/// that go the same way side by side enclose a beam. Cells at edges and folds are halved.
/// The same for any number of threads. Throws Cancelled.
std::vector<Beam> beams_of(const LightChart& chart, const LightPaths& paths,
                           const CausticSpec& spec, const Job& job);

} // namespace keiko
