#include "keiko/inspect/overlaps/sheet_cell.h"

#include "keiko/base/units.h"
#include "keiko/geometry/bezier/subpatch.h"

#include <algorithm>

namespace keiko {
namespace {

/// Ranges of the coordinates of points along a direction, mm.
Interval extent_along(const std::vector<Vec3>& points, const Vec3& direction) {
    Interval range{direction.dot(points.front())};
    for (const Vec3& p : points) {
        const double at = direction.dot(p);
        range.low = std::min(range.low, at), range.high = std::max(range.high, at);
    }
    return range;
}

bool are_apart(const Interval& a, const Interval& b, double distance) {
    return a.low - b.high > distance || b.low - a.high > distance;
}

} // namespace

SheetCell::SheetCell(const FaceSheet& sheet, const Box2& box) : sheet_(sheet), box_(box) {
    parts_ = sheet.present_parts(box);
    Vec3 across(0);
    for (const FaceSheet::Part& part : parts_) {
        const std::vector<Vec4> points = subpatch(part.view, part.uv);
        const BezierPatchView piece{part.view.degree_u, part.view.degree_v, points};
        for (const Vec4& p : points) points_.push_back(euclidean(p)), hull_.extend(points_.back());
        const Vec3 a = euclidean(piece.point(0, 0));
        const Vec3 d = euclidean(piece.point(piece.degree_u, piece.degree_v));
        const Vec3 b = euclidean(piece.point(piece.degree_u, 0));
        const Vec3 c = euclidean(piece.point(0, piece.degree_v));
        across += (d - a).cross(c - b);
    }
    if (across.length() > 0) normal_ = across.normalized();
}

bool SheetCell::is_apart(const SheetCell& other, double distance) const {
    for (unsigned k = 0; k < 3; ++k)
        if (are_apart({hull_.lower[k], hull_.upper[k]},
                      {other.hull_.lower[k], other.hull_.upper[k]}, distance))
            return true;
    const Vec3 line = hull_.center() - other.hull_.center();
    for (const Vec3& axis : {normal_, other.normal_, line}) {
        const double length = axis.length();
        if (!(length > 0)) continue;
        const Vec3 unit = axis / length;
        if (are_apart(extent_along(points_, unit), extent_along(other.points_, unit), distance))
            return true;
    }
    return false;
}

unsigned SheetCell::longer_axis() const {
    if (parts_.size() != 1) return box_.extent().x >= box_.extent().y ? 0 : 1;
    const FaceSheet::Part& part = parts_.front();
    std::array<double, 2> lengths{}, turns{};
    for (const unsigned axis : {0U, 1U}) {
        Vec2 begin(0.5), end(0.5);
        begin[axis] = 0, end[axis] = 1;
        const auto at = [&](const Vec2& share) {
            return evaluate(part.view, part.uv.lower + part.uv.extent() * share, 1);
        };
        const SurfaceDerivatives a = at(begin), b = at(Vec2(0.5)), c = at(end);
        lengths[axis] = std::max((b.position() - a.position()).length(),
                                 (c.position() - b.position()).length());
        turns[axis] = angle_between(a.du().cross(a.dv()), c.du().cross(c.dv()));
    }
    // A bend is cut into strips along it: they are apart, however long.
    constexpr double much = degrees_to_radians(30);
    const bool bends = std::max(turns[0], turns[1]) > much;
    return (bends ? turns[0] >= turns[1] : lengths[0] >= lengths[1]) ? 0 : 1;
}

std::array<SheetCell*, 2> SheetCell::halves(unsigned axis) {
    auto& halves = halves_[axis];
    if (!halves[0]) {
        Box2 low = box_, high = box_;
        low.upper[axis] = high.lower[axis] = sheet_.cut(box_, axis);
        halves = {std::make_unique<SheetCell>(sheet_, low),
                  std::make_unique<SheetCell>(sheet_, high)};
    }
    return {halves[0].get(), halves[1].get()};
}

} // namespace keiko
