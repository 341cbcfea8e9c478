#include "keiko/visibility/silhouettes/view_volume.h"

#include "keiko/math/axes.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// The direction of the longest way between two corners, so that a pyramid over lamps is as narrow
/// as they lie.
Vec3 longest_way(std::span<const Vec3> corners) {
    Vec3 longest(0);
    double most = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = i + 1; k < corners.size(); ++k) {
            const Vec3 way = corners[k] - corners[i];
            if (const double length2 = way.length2(); length2 > most) longest = way, most = length2;
        }
    return longest;
}

double farthest(std::span<const Vec3> points, const Vec3& way) {
    double most = -Box3::infinity;
    for (const Vec3& point : points) most = std::max(most, way.dot(point));
    return most;
}

/// Unit vectors across `axis`, the first as near to `along` as can be.
std::array<Vec3, 2> across(const Vec3& axis, const Vec3& along) {
    Vec3 x = along - axis * along.dot(axis);
    if (!(x.length() > 1e-6 * along.length())) x = any_perpendicular(axis);
    x.normalize();
    return {x, axis.cross(x)};
}

} // namespace

ViewVolume::ViewVolume(const Viewpoint& viewpoint, std::span<const Vec3> region,
                       const std::optional<Vec3>& facing) {
    for (const Vec3& corner : region) region_.extend(corner);
    const Vec3 middle = middle_of(region);
    const Vec3 axis = viewpoint.way_to(middle).normalized();
    const std::array<Vec3, 2> beside = across(axis, longest_way(region));
    // Far beyond what rounding in the tests could move.
    constexpr double margin = 1e-9;
    const Vec3 origin = viewpoint.infinite() ? middle : viewpoint.place();
    const double reach = region_.size() + (middle - origin).length();
    double nearest = Box3::infinity, farthest = -Box3::infinity;
    Box2 slopes;
    for (const Vec3& corner : region) {
        const Vec3 x = corner - origin;
        const double depth = x.dot(axis), unit = viewpoint.infinite() ? 1 : depth;
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
        slopes.extend(Vec2(x.dot(beside[0]), x.dot(beside[1])) / unit);
    }
    add(-axis, -axis.dot(origin) - farthest - margin * reach);
    if (facing) add(*facing, facing->dot(origin) - margin * reach);
    hull_ = {Vec3(-Box3::infinity), Vec3(Box3::infinity)};
    if (!viewpoint.infinite()) {
        hull_ = region_;
        hull_.extend(viewpoint.place());
        // A region that reaches behind the viewpoint is in no pyramid.
        if (!(nearest > 0)) return;
    }
    for (unsigned k = 0; k < 2; ++k) {
        const double pad = margin * (1 + std::abs(slopes.lower[k]) + std::abs(slopes.upper[k]));
        const Vec3 depth = viewpoint.infinite() ? Vec3(0) : axis;
        const double shift = viewpoint.infinite() ? 1 : 0;
        const double low = slopes.lower[k] - pad, high = slopes.upper[k] + pad;
        const Vec3 above = beside[k] - depth * low, below = depth * high - beside[k];
        add(above, above.dot(origin) + shift * low - margin * reach);
        add(below, below.dot(origin) - shift * high - margin * reach);
    }
}

ViewVolume::ViewVolume(std::span<const Vec3> places, std::span<const Vec3> region,
                       const std::optional<Vec3>& facing) {
    for (const Vec3& corner : region) region_.extend(corner);
    Box3 around;
    for (const Vec3& place : places) around.extend(place);
    hull_ = region_;
    hull_.extend(around.lower), hull_.extend(around.upper);
    const double reach = hull_.size();
    constexpr double margin = 1e-9;
    // The places' own rounding separates what lies in the surface from what stands on it.
    const double above = margin * (around.size() + around.center().length());
    if (facing) add(*facing, farthest(places, *facing) + above);
    const auto add_behind = [&](const Vec3& outward) {
        const double most = std::max(farthest(places, outward), farthest(region, outward));
        add(-outward, -most - margin * reach);
    };
    const Vec3 way = middle_of(region) - middle_of(places), axis = way.normalized();
    add_behind(axis);
    add_behind(-axis);
    for (const Vec3& beside : across(axis, longest_way(region)))
        for (const Vec3& side : {beside, -beside}) {
            const double widens = farthest(region, side) - farthest(places, side);
            add_behind(side - axis * (widens / way.length()));
        }
}

void ViewVolume::add(const Vec3& normal, double offset) {
    half_spaces_[count_++] = {normal, magnitudes(normal), offset, normal.length()};
}

bool ViewVolume::may_hold(const AffineBounds& points, const NetFrame& frame, Sides& sides) const {
    return may_hold(sides, [&](const HalfSpace& h) {
        const double inside = h.normal.dot(frame.center) - h.offset;
        const Vec4 weights(h.normal.x, h.normal.y, h.normal.z, inside);
        const AffineBounds::Weighed depth = points.weighed(frame.local(weights));
        return Depth{depth.least(), depth.most()};
    });
}

bool ViewVolume::may_hold(const SilhouettePiece& piece, Sides& sides) const {
    return may_hold(piece.points, piece.frame, sides);
}

bool ViewVolume::may_hold(const BoundaryPiece& border, Sides& sides) const {
    return may_hold(border.curve, border.center, border.error, sides);
}

bool ViewVolume::may_hold(const BoundaryPiece::Curve& curve, const Vec3& center, double error,
                          Sides& sides) const {
    return may_hold(sides, [&](const HalfSpace& h) {
        double least = h.normal.dot(curve[0]), most = least;
        for (std::size_t i = 1; i < curve.size(); ++i) {
            const double along = h.normal.dot(curve[i]);
            least = std::min(least, along), most = std::max(most, along);
        }
        const double inside = h.normal.dot(center) - h.offset, room = error * h.length;
        return Depth{inside + least - room, inside + most + room};
    });
}

bool ViewVolume::may_hold(const Box3& box, Sides& sides) const {
    if (sides == 0) return true;
    if (!box.overlaps(hull_)) return false;
    const Vec3 center = box.center(), half = box.extent() * 0.5;
    return may_hold(sides, [&](const HalfSpace& h) {
        const double middle = h.normal.dot(center) - h.offset, reach = h.size.dot(half);
        return Depth{middle - reach, middle + reach};
    });
}

} // namespace keiko
