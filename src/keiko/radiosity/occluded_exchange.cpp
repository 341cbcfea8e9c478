#include "keiko/radiosity/occluded_exchange.h"

#include "keiko/base/job.h"
#include "keiko/light/areas/area_penumbra.h"
#include "keiko/light/luminance/projected_solid_angle.h"
#include "keiko/math/polygon.h"
#include "keiko/radiosity/exchange_area.h"
#include "keiko/radiosity/point_visibility.h"
#include "keiko/radiosity/triangle_cubature.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace keiko {
namespace {

/// Share of its size by which a polygon is lifted off its plane, and drawn in, for queries: it does
/// not hide itself if it is among the occluders, nor do those that it touches.
constexpr double lifted = 1e-6;
/// Widest spacing of queried lines, of half the width, as for the light of panels.
constexpr double widest_spacing = 0.12;

Vec3 lift_of(std::span<const Vec3> corners) {
    const Vec3 normal = polygon_normal(corners);
    return normal.normalized() * (lifted * std::sqrt(normal.length()));
}

std::vector<Vec3> queried(std::span<const Vec3> corners) {
    const Vec3 middle = middle_of(corners), lift = lift_of(corners);
    std::vector<Vec3> inner;
    for (const Vec3& corner : corners) inner.push_back(corner + (middle - corner) * lifted + lift);
    return inner;
}

/// An element before another, past occluders.
class HiddenElement {
public:
    HiddenElement(std::span<const Vec3> corners, std::span<const Vec3> from,
                  const Occluders& occluders, double tolerance)
        : corners_(corners),
          light_{queried(corners), Rgb(1)},
          lift_(lift_of(from)),
          normal_(lift_.normalized()),
          occluders_(occluders),
          options_{tolerance, widest_spacing, true} {}

    const std::vector<Vec3>& asked() const { return light_.corners; }
    const Vec3& normal() const { return normal_; }

    /// Form factor of the hidden part from a point of the other.
    double operator()(const Vec3& point) const {
        const double whole = projected_solid_angle(corners_, point, normal_);
        return whole > 0 ? whole * (1 - share_seen(point)) / std::numbers::pi : 0;
    }
    /// Share of the projected solid angle that a point of the other sees.
    double share_seen(const Vec3& point) const {
        check_stop();
        const Vec3 above = point + lift_;
        const PointVisibility visible(occluders_, above, normal_, light_.corners);
        return visible_share(light_, above, normal_, visible, options_);
    }

private:
    std::span<const Vec3> corners_;
    PolygonLight light_;
    Vec3 lift_, normal_;
    const Occluders& occluders_;
    WidthOptions options_;
};

} // namespace

ExchangeArea occluded_exchange_area(std::span<const Vec3> first, std::span<const Vec3> second,
                                    const Occluders& occluders, const ExchangeOptions& options) {
    const double whole = direct_exchange_area(first, second);
    if (!(whole > 0)) return {};
    const std::vector<Vec3> a = part_before(first, second[0], polygon_normal(second));
    const std::vector<Vec3> b = part_before(second, first[0], polygon_normal(first));
    constexpr double one_half = 0.5;
    const double half = options.error / 2;
    const HiddenElement hidden(b, a, occluders, half);
    if (!occluders.may_occlude(queried(a), hidden.asked(), hidden.normal()))
        return {hidden.share_seen(middle_of(a)) < one_half ? 0 : whole, 0}; // it is 0 or 1
    const CubatureSum sum = integrate_adaptively_over(a, hidden, half * whole, options.most_parts);
    return {whole - sum.value, sum.error + half * whole};
}

} // namespace keiko
