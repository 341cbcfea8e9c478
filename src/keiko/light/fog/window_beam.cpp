#include "keiko/light/fog/window_beam.h"

#include "keiko/light/fog/refined_integral.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/math/polygon.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// True if a point of the window's plane is in the polygon, viewed along the largest component of
/// the normal.
bool holds(const Window& window, const Vec3& normal, const Vec3& point) {
    const Vec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const unsigned skipped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const unsigned u = skipped == 0 ? 1 : 0, v = skipped == 2 ? 1 : 2;
    std::vector<Vec2> corners;
    for (const Vec3& corner : window.corners) corners.emplace_back(corner[u], corner[v]);
    return keiko::holds(corners, {point[u], point[v]});
}

/// Distance behind the window's plane along the light, of any sign.
double depth_behind(const Window& window, const Vec3& normal, const Vec3& direction,
                    const Vec3& point) {
    return normal.dot(point - window.corners.front()) / normal.dot(direction);
}

/// The light along the ray, at one parameter of it.
class BeamRay {
public:
    BeamRay(const AttenuatedRay& camera_ray, const ParallelBeam& beam)
        : medium_(camera_ray.medium()),
          ray_(camera_ray.ray()),
          beam_(beam),
          normal_(polygon_normal(beam.window.corners)),
          length_((ray_.b - ray_.a).length()),
          phase_(phase(medium_.phase, -(ray_.b - ray_.a).dot(beam.direction) / length_)),
          dimmed_(camera_ray) {}

    /// Scattered luminance per parameter of the ray.
    Rgb operator()(double t) const {
        const Vec3 point = ray_.at(t);
        Rgb depth = dimmed_.depth_to(t);
        if (medium_.dims_light_leg)
            depth += optical_depth(medium_, {point - beam_.direction * behind(point), point});
        return extinction_at(medium_, point) * medium_.albedo * beam_.illuminance *
               transmittance(depth) * (phase_ * metres(length_));
    }

    /// Luminance scattered in a part of the ray in a uniform medium: the exponent is linear along
    /// the ray.
    Rgb closed_form(const ParameterInterval& part) const {
        const double first = behind(ray_.at(part.begin)), last = behind(ray_.at(part.end));
        const double leg = medium_.dims_light_leg ? 1 : 0;
        const auto channel = [&](double extinction, double scattered) {
            const double begin = extinction * metres(part.begin * length_ + leg * first);
            const double gone = extinction * metres(part.length() * length_ + leg * (last - first));
            const double mean = std::abs(gone) > 1e-300 ? -std::expm1(-gone) / gone : 1;
            return scattered * phase_ * std::exp(-begin) * mean * metres(part.length() * length_);
        };
        const Rgb& extinction = medium_.extinction;
        const Rgb scattered = extinction * medium_.albedo * beam_.illuminance;
        return {channel(extinction.r, scattered.r), channel(extinction.g, scattered.g),
                channel(extinction.b, scattered.b)};
    }

    std::vector<double> pieces(const ParameterInterval& part) const {
        return smooth_pieces(part, dimmed_.breaks());
    }

private:
    double behind(const Vec3& point) const {
        return depth_behind(beam_.window, normal_, beam_.direction, point);
    }

    const Medium& medium_;
    const Segment& ray_;
    const ParallelBeam& beam_;
    Vec3 normal_;
    double length_;
    double phase_;
    const AttenuatedRay& dimmed_;
};

} // namespace

std::optional<double> way_from_window(const Window& window, const Vec3& direction,
                                      const Vec3& point) {
    const Vec3 normal = polygon_normal(window.corners);
    if (!(std::abs(normal.dot(direction)) > 1e-12 * normal.length())) return {};
    const double way = depth_behind(window, normal, direction, point);
    if (!(way >= 0) || !holds(window, normal, point - direction * way)) return {};
    return way;
}

IntervalSet in_window_beam(const Window& window, const Vec3& direction, const Segment& segment) {
    const Vec3 way = segment.b - segment.a, normal = polygon_normal(window.corners);
    std::vector<double> ends{0, 1};
    const auto cut = [&](const Vec3& plane, const Vec3& through) {
        const double t = plane.dot(through - segment.a) / plane.dot(way);
        if (t > 0 && t < 1) ends.push_back(t);
    };
    cut(normal, window.corners.front());
    const std::size_t count = window.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 &a = window.corners[i], &b = window.corners[(i + 1) % count];
        cut((b - a).cross(direction), a);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<ParameterInterval> lit;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (way_from_window(window, direction, segment.at((ends[i] + ends[i + 1]) / 2)))
            lit.push_back({ends[i], ends[i + 1]});
    return IntervalSet(std::move(lit));
}

Rgb scattered_light(const AttenuatedRay& camera_ray, const IntervalSet& lit,
                    const ParallelBeam& beam, double tolerance) {
    if (!(camera_ray.ray().b != camera_ray.ray().a) || lit.empty()) return {};
    const BeamRay f(camera_ray, beam);
    const bool even = std::holds_alternative<HomogeneousDensity>(camera_ray.medium().density);
    Rgb sum;
    for (const ParameterInterval& part : lit)
        sum += even ? f.closed_form(part) : RefinedIntegral(f, tolerance)(f.pieces(part));
    return sum;
}

} // namespace keiko
