#pragma once

#include "keiko/base/export.h"
#include "keiko/light/areas/area_lights.h"
#include "keiko/light/areas/sign.h"
#include "keiko/light/fog/medium.h"
#include "keiko/light/fog/window_beam.h"
#include "keiko/light/lines/line_light.h"
#include "keiko/light/sky/sky_light.h"
#include "keiko/light/spotlight/luminaire.h"
#include "keiko/light/spotlight/point_source.h"
#include "keiko/light/spotlight/spotlight.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <concepts>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace KEIKO_API keiko {

/// Parallel light. If it comes in through windows, it lights only what lies behind them, and the
/// medium attenuates and scatters it from the window on. Without windows the medium does neither.
struct Sun {
    Vec3 direction{0, 0, -1}; ///< direction of the light; of any length but 0
    Rgb illuminance{60000};   ///< lx on a surface across the light, past the air; colour included
    std::vector<Window> windows{}; ///< empty: it shines from everywhere
    bool shaft = true;             ///< it lights the medium behind its windows

    /// Unit vector towards the light.
    Vec3 towards() const { return direction / -direction.length(); }
    /// A place on the way to it, mm, far enough that nothing in a scene lies beyond.
    Vec3 seen_from(const Vec3& point) const { return point + towards() * 1e7; }
    /// Distance, mm, that light reaching a point travels through the room: 0 without windows,
    /// nullopt if no window lets it in.
    std::optional<double> way_to(const Vec3& point) const {
        if (windows.empty()) return 0;
        std::optional<double> longest;
        for (const Window& window : windows)
            if (const auto way = way_from_window(window, direction.normalized(), point))
                longest = std::max(longest.value_or(0), *way);
        return longest;
    }
};

/// Every kind of light source a rig can hold.
using LightSource =
    std::variant<CPlane, Spotlight, Luminaire, Sun, PolygonLight, SphereLight, PointSource,
                 LineLight, SkyLight, DiscLight, FrustumLight, EllipsoidLight, ContourLight>;

/// Lights with an extent that are no rows of tubes. They light surfaces alone, and no medium.
template <class Light>
concept ExtendedLight = AreaLight<Light> || std::same_as<Light, LineLight>;

/// All lights of a scene and the air between them. Placement writes one, every picture reads one.
struct LightRig {
    std::string name;                 ///< or empty
    std::vector<LightSource> sources; ///< all lights, in order
    /// Signs, for those who read them; their panels are among the sources.
    std::vector<LuminousSign> signs{};
    Rgb ambient{0};                 ///< lx of unshadowed ambient illuminance on every surface
    std::optional<Medium> medium{}; ///< the air between them; none: vacuum
};

} // namespace keiko
