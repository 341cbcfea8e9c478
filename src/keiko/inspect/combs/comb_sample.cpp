#include "keiko/inspect/combs/comb_sample.h"

#include "keiko/geometry/bezier/differential_geometry.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

Vec3 along(const SurfaceDerivatives& s, const Vec2& direction) {
    return s.du() * direction.x + s.dv() * direction.y;
}

Vec3 twice_along(const SurfaceDerivatives& s, const Vec2& direction) {
    return s.duu() * (direction.x * direction.x) + s.duv() * (2 * direction.x * direction.y) +
           s.dvv() * (direction.y * direction.y);
}

constexpr int most_halvings = 8; ///< between two points of a curve

class CombSampler {
public:
    CombSampler(const BezierPatchView& view, const ZeroFunction& zeros, const BendAt& bend,
                const CombSampling& sampling)
        : view_(view), zeros_(zeros), bend_(bend), sampling_(sampling) {}

    std::vector<CombSample> run(const PatchLine& line) {
        const std::vector<Point> points = reliable(line);
        largest_ = 1 / sampling_.size;
        for (const Point& point : points)
            largest_ = std::max(largest_, std::abs(point.sample.bend.curvature));
        if (points.empty()) return {};
        samples_ = {points.front().sample};
        for (std::size_t i = 1; i < points.size(); ++i)
            fill(points[i - 1], points[i], most_halvings);
        return std::move(samples_);
    }

private:
    struct Point {
        LinePoint at;
        CombSample sample;
    };

    /// The points of a line at which its curvature can be computed, and the last ones before
    /// points, such as poles, where it cannot.
    std::vector<Point> reliable(const PatchLine& line) const {
        std::vector<Point> points;
        const LinePoint* unknown = nullptr;
        for (const LinePoint& at : line.points) {
            const auto found = sample_at(at);
            if (found && unknown) points.push_back(nearest({at, *found}, *unknown));
            if (found) points.push_back({at, *found});
            if (!found && !unknown && !points.empty()) points.push_back(nearest(points.back(), at));
            unknown = found ? nullptr : &at;
        }
        return points;
    }

    /// The point nearest to a place of unknown curvature at which it can be computed.
    Point nearest(Point known, LinePoint unknown) const {
        while ((unknown.place - known.at.place).length() > sampling_.chord_error) {
            const auto at = zeros_.between(known.at, unknown, 0.5);
            if (!at) break;
            if (const auto found = sample_at(*at))
                known = {*at, *found};
            else
                unknown = *at;
        }
        return known;
    }

    std::optional<CombSample> sample_at(const LinePoint& at) const {
        const SurfaceDerivatives s = evaluate(view_, at.uv, 2);
        const std::optional<Vec3> normal = unit_normal(s, at.uv);
        if (!normal || !has_reliable_curvatures(s, *normal)) return std::nullopt;
        const auto bend = bend_(s, at.uv, *normal);
        if (!bend) return std::nullopt;
        return CombSample{at.place, 0, *bend};
    }

    void fill(const Point& a, const Point& b, int halvings) {
        const auto at = halvings > 0 ? zeros_.between(a.at, b.at, 0.5) : std::nullopt;
        const auto found = at ? sample_at(*at) : std::nullopt;
        if (!found) {
            samples_.push_back(b.sample);
            return;
        }
        const double straight = (a.sample.bend.curvature + b.sample.bend.curvature) / 2;
        const double off = std::abs(found->bend.curvature - straight);
        const int left = off <= sampling_.tolerance * largest_ ? 0 : halvings - 1;
        fill(a, {*at, *found}, left);
        fill({*at, *found}, b, left);
    }

    const BezierPatchView& view_;
    const ZeroFunction& zeros_;
    const BendAt& bend_;
    const CombSampling& sampling_;
    double largest_ = 0; ///< 1/mm
    std::vector<CombSample> samples_;
};

} // namespace

std::optional<CurveBend> normal_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                     const Vec2& direction) {
    const Vec3 tangent = along(s, direction);
    const double curvature = twice_along(s, direction).dot(outward) / tangent.dot(tangent);
    if (!std::isfinite(curvature)) return std::nullopt;
    return CurveBend{curvature, curvature, outward};
}

std::optional<CurveBend> section_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                      const Vec3& plane) {
    constexpr double least_sine = 1e-6;
    const Vec3 in_plane = outward - plane * plane.dot(outward);
    const double sine = in_plane.length();
    if (!(sine > least_sine)) return std::nullopt;
    // Along the curve the plane's height is constant.
    const Vec2 level(plane.dot(s.dv()), -plane.dot(s.du()));
    auto bend = normal_bend(s, outward, level);
    if (!bend) return std::nullopt;
    bend->curvature /= sine;
    bend->towards = in_plane / sine;
    return bend;
}

std::optional<CurveBend> touching_bend(const SurfaceDerivatives& s, const Vec3& plane,
                                       const Vec2& direction, const Vec2& turning) {
    const Vec3 tangent = along(s, direction),
               second = twice_along(s, direction) + along(s, turning);
    const Vec3 left = plane.cross(tangent).normalized();
    const double curvature = second.dot(left) / tangent.dot(tangent);
    if (!std::isfinite(curvature)) return std::nullopt;
    return CurveBend{curvature, 0, left};
}

std::vector<CombSample> comb_samples(const BezierPatchView& view, const ZeroFunction& zeros,
                                     const PatchLine& line, const BendAt& bend,
                                     const CombSampling& sampling) {
    return CombSampler(view, zeros, bend, sampling).run(line);
}

} // namespace keiko
