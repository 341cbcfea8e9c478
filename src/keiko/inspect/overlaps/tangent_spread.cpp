#include "keiko/inspect/overlaps/tangent_spread.h"

#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/inspect/basics/patch_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Vectors whose convex hull holds the tangents of a piece along s or t, mm a unit.
class TangentHull {
public:
    /// Adds those of a part along s (`along_s`) or t.
    void add(const BezierPatchView& piece, bool along_s, double extent);

    /// True if there is a direction to measure from.
    bool has_axis() const { return axis_.length() > 0; }
    Vec3 axis() const { return axis_.normalized(); }
    /// Radians, the largest angle of a tangent from the axis.
    double spread() const;
    /// No mean of tangents is shorter; 0 or less if they are not known to run one way.
    double least() const;
    /// No tangent is longer.
    double most() const { return most_; }
    /// Mean of the vectors.
    Vec3 middle() const;
    /// The tangents less `share` of others, those of the same parts.
    TangentHull sheared(const TangentHull& other, double share) const;

private:
    void add(const Vec3& tangent);

    std::vector<Vec3> tangents_;
    Vec3 axis_{0};
    double most_ = 0;
};

/// The tangent of a rational piece is N / w^2. With the Bernstein coefficients N_i and W_i > 0 of
/// both, by the same degrees, it is a mean of the vectors N_i / W_i with the weights W_i B_i.
void TangentHull::add(const BezierPatchView& piece, bool along_s, double extent) {
    const BernsteinField w = homogeneous_field(piece, 0).w;
    const BernsteinField one =
        along_s ? BernsteinField(1, 0, {1, 1}, 0) : BernsteinField(0, 1, {1, 1}, 0);
    const BernsteinField weight = piece.rational() ? w * w : w;
    FieldTriple n = tangent_field(piece, along_s, 0);
    for (BernsteinField& of : n) of = of * one;
    for (int i = 0; i <= weight.degree_u(); ++i)
        for (int j = 0; j <= weight.degree_v(); ++j) {
            const Vec3 tangent =
                Vec3(n[0].at(i, j), n[1].at(i, j), n[2].at(i, j)) / (weight.at(i, j) * extent);
            add(tangent);
        }
}

void TangentHull::add(const Vec3& tangent) {
    const double length = tangent.length();
    tangents_.push_back(tangent);
    most_ = std::max(most_, length);
    if (length > 0) axis_ += tangent / length;
}

double TangentHull::spread() const {
    double most = 0;
    for (const Vec3& tangent : tangents_) {
        if (!(tangent.length() > 0)) return std::numbers::pi;
        most = std::max(most, angle_between(axis_, tangent));
    }
    return most;
}

double TangentHull::least() const {
    double least = infinity;
    const Vec3 along = axis();
    for (const Vec3& tangent : tangents_) least = std::min(least, tangent.dot(along));
    return least;
}

Vec3 TangentHull::middle() const {
    Vec3 sum(0);
    for (const Vec3& tangent : tangents_) sum += tangent;
    return sum / static_cast<double>(tangents_.size());
}

TangentHull TangentHull::sheared(const TangentHull& other, double share) const {
    TangentHull hull;
    for (std::size_t i = 0; i < tangents_.size(); ++i)
        hull.add(tangents_[i] - other.tangents_[i] * share);
    return hull;
}

/// Bound of the ratio of the way between two places to their distance; infinite if the tangents
/// along s and t are not proved to keep apart.
double longest_detour(const TangentHull& along_s, const TangentHull& along_t) {
    if (!along_s.has_axis() || !along_t.has_axis()) return infinity;
    const double between = angle_between(along_s.axis(), along_t.axis());
    const double apart =
        std::min(between, std::numbers::pi - between) - along_s.spread() - along_t.spread();
    const double least_s = along_s.least(), least_t = along_t.least();
    if (!(apart > 0 && least_s > 0 && least_t > 0)) return infinity;
    return (along_s.most() / least_s + along_t.most() / least_t) / std::sin(apart);
}

/// The tangents along s less the share of those along t that leaves them square to these in the
/// mean. The parameters are sheared by it, and straight lines remain straight.
TangentHull squared(const TangentHull& along_s, const TangentHull& along_t) {
    const Vec3 along = along_t.middle();
    return along_s.sheared(along_t,
                           along_s.middle().dot(along) / std::max(along.length2(), 1e-300));
}

/// Bound of the way between two places less than `least` mm apart, of a strip `width` mm wide. They
/// are at least as far apart as they are along the strip, less the width.
double longest_way_in_strip(const TangentHull& along, double width, double least) {
    const double shortest = along.has_axis() ? along.least() : 0;
    if (!(shortest > 0)) return infinity;
    return (least + width) * along.most() / shortest + width;
}

} // namespace

bool near_places_are_neighbours(std::span<const FaceSheet::Part> parts, const Vec2& extent,
                                double least, double longest) {
    TangentHull along_s, along_t;
    for (const FaceSheet::Part& part : parts) {
        const std::vector<Vec4> points = subpatch(part.view, part.uv);
        const BezierPatchView piece{part.view.degree_u, part.view.degree_v, points};
        along_s.add(piece, true, part.extent.x);
        along_t.add(piece, false, part.extent.y);
    }
    const auto are_neighbours = [&](const TangentHull& s, const TangentHull& t) {
        return longest_detour(s, t) * least <= longest ||
               longest_way_in_strip(s, t.most() * extent.y, least) <= longest ||
               longest_way_in_strip(t, s.most() * extent.x, least) <= longest;
    };
    return are_neighbours(along_s, along_t) || are_neighbours(squared(along_s, along_t), along_t) ||
           are_neighbours(along_s, squared(along_t, along_s));
}

} // namespace keiko
