#include "keiko/inspect/overlaps/piece_slab.h"

#include <algorithm>

namespace keiko {
namespace {

/// Restricts an interval of s to low <= from + s * slope <= high.
void cut(ParameterInterval& part, double from, double slope, double low, double high) {
    if (slope == 0) {
        if (!(low <= from && from <= high)) part = {1, 0};
        return;
    }
    const auto [begin, end] = std::minmax({(low - from) / slope, (high - from) / slope});
    part.begin = std::max(part.begin, begin), part.end = std::min(part.end, end);
}

} // namespace

PieceSlab::PieceSlab(const BezierPatchView& piece, double reach) {
    const Vec3 a = euclidean(piece.point(0, 0)), b = euclidean(piece.point(piece.degree_u, 0));
    const Vec3 c = euclidean(piece.point(0, piece.degree_v));
    const Vec3 d = euclidean(piece.point(piece.degree_u, piece.degree_v));
    longer_side_ =
        (b - a).length() + (d - c).length() >= (c - a).length() + (d - b).length() ? 0 : 1;
    const Box3 hull = hull_bounds(piece);
    size_ = thickness_ = hull.size();
    box_ = hull.padded(reach);
    const Vec3 across = (d - a).cross(c - b);
    if (!(across.length() > 0)) return;
    normal_ = across / across.length();
    low_ = high_ = normal_.dot(a);
    for (const Vec4& point : piece.points) {
        const double height = normal_.dot(euclidean(point));
        low_ = std::min(low_, height), high_ = std::max(high_, height);
    }
    thickness_ = high_ - low_;
    low_ -= reach, high_ += reach;
}

std::optional<ParameterInterval> PieceSlab::clip(const Vec3& from, const Vec3& to) const {
    const Vec3 way = to - from;
    ParameterInterval part{0, 1};
    for (unsigned k = 0; k < 3; ++k) cut(part, from[k], way[k], box_.lower[k], box_.upper[k]);
    if (normal_ != Vec3(0)) cut(part, normal_.dot(from), normal_.dot(way), low_, high_);
    return part.begin <= part.end ? std::optional(part) : std::nullopt;
}

} // namespace keiko
