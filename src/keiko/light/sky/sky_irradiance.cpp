#include "keiko/light/sky/sky_irradiance.h"

#include "keiko/light/luminance/irradiance_tensor.h"
#include "keiko/light/luminance/projected_solid_angle.h"
#include "keiko/light/sky/window_overlap.h"
#include "keiko/math/convex_clip.h"
#include "keiko/math/quadrature.h"

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
/// Relative error of a clear sky's light, by the difference of two rules.
constexpr double of_clear_sky = 1e-4;

/// The integral of (N.w) w.z over the part of a polygon above the horizon of a surface element.
double rise_moment(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    std::vector<Vec3> above;
    clip_convex(
        corners, [&](std::size_t i) { return normal.dot(corners[i] - point); },
        [&](const Vec3& corner) { above.push_back(corner - point); });
    return second_irradiance_moment(above, normal, Vec3(0, 0, 1));
}

/// Projected solid angle weighted by the luminance, by lines across the panel.
double by_lines(const SkyWidth& width) {
    const auto lit = [&](double place) {
        const SubAxis axis = width.sub_axis(place);
        return width.lit(axis, 0, 1) * axis.weight;
    };
    double sum = 0;
    const std::vector<double> cuts = width.cuts();
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        sum += integrate_paired(lit, Breakpoints(cuts[i], cuts[i + 1]), of_clear_sky);
    return sum;
}

/// Illuminance by a panel of 1 cd/m2 at the zenith, or of ground.
double weighted_solid_angle(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                            const Vec3& normal) {
    const SkyDistribution shares(sky);
    const std::vector<Vec3>& corners = panel.outline.corners;
    if (panel.ground) return projected_solid_angle(corners, point, normal);
    if (!shares.is_linear()) {
        const auto width = SkyWidth::of(sky, panel, point, normal);
        return width ? by_lines(*width) : 0;
    }
    const double even = shares.level() * projected_solid_angle(corners, point, normal);
    return shares.rise() == 0 ? even : even + shares.rise() * rise_moment(corners, point, normal);
}

} // namespace

double unobstructed_illuminance(const SkyLight& sky, const Vec3& normal) {
    const SkyDistribution shares(sky);
    if (shares.is_linear()) {
        const double tilt = angle_between(normal, Vec3(0, 0, 1)), cosine = std::cos(tilt);
        return shares.level() * pi / 2 * (1 + cosine) +
               shares.rise() * 2 / 3 * ((pi - tilt) * cosine + std::sin(tilt));
    }
    SkyLight open = sky;
    open.windows.clear(), open.ground = Rgb(0);
    double sum = 0;
    for (int i = 0; i < panel_count(open); ++i)
        sum += weighted_solid_angle(open, *sky_panel(open, i, Vec3(0)), Vec3(0), normal);
    return sum;
}

Rgb illuminance_from(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                     const Vec3& normal) {
    return (panel.ground ? sky.ground : sky.luminance) *
           weighted_solid_angle(sky, panel, point, normal);
}

double panel_share(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                   const Vec3& normal) {
    const double above = max_channel(sky.luminance), below = max_channel(sky.ground);
    const double all = pi / 2 * (above * (1 + normal.z) + below * (1 - normal.z));
    if (sky.model == SkyModel::clear || !sky.windows.empty() || !(all > 0)) return 0.25;
    return (panel.ground ? below : above) *
           projected_solid_angle(panel.outline.corners, point, normal) / all;
}

double visible_share(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                     const Vec3& normal, const Visibility& visible, const WidthOptions& options) {
    const auto width = SkyWidth::of(sky, panel, point, normal);
    if (!width) return 1;
    if (panel.others.empty()) return visible_share(*width, visible, options);
    const WindowOverlap beside(visible, panel.outline.corners, panel.others, point);
    return visible_share(*width, beside, options);
}

} // namespace keiko
