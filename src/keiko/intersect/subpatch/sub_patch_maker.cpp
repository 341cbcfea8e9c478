#include "keiko/base/job.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/intersect/subpatch/sub_patch.h"
#include "keiko/intersect/subpatch/sub_patch_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Share of a sub-patch's width by which neighbours overlap, so that no ray slips through between
/// them.
constexpr double overlap = 1e-11;
/// A sub-patch so small beside its coordinates' rounding errors is a point; it gets no wider
/// overlap.
constexpr double widest_overlap = 1e-6;

/// Bounds, in parameters of the sub-patch, of how far apart along u and along v two places may be
/// that are `distance` mm apart by the tangents anywhere on the sub-patch.
Vec2 farthest_apart(const SubPatchFrame& f, double distance) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!f.regular) return Vec2(infinity);
    const auto bound = [&](const ComponentBounds& own, const Vec3& row) {
        // X = (x + e) / w, so X_x = (1 + e_x - X w_x) / w.
        const double farthest = (1 + own.value) / (1 - f.w.value);
        const double least = (1 - own.slope - farthest * f.w.slope) / (1 + f.w.value);
        const bool known = f.w.value < 1 && least > 0;
        return known ? 0.5 * distance * row.length() / least * (1 + 1e-9) : infinity;
    };
    return {bound(f.u, f.rows[0]), bound(f.v, f.rows[1])};
}

/// Bound of how far the unit normal may be, anywhere on the sub-patch, from that of the frame.
double normal_spread(const SubPatchFrame& f) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!f.regular || !(f.w.value <= 0.5)) return infinity; // as f.height asks for
    // X = (x + e) / w, so X_x = (1 + e_x - X w_x) / w: by how much that may be off 1 / w.
    const double least = 1 / (1 + f.w.value), most = 1 / (1 - f.w.value);
    const auto slope = [&](const ComponentBounds& own, double farthest) {
        return (own.slope + farthest * f.w.slope) * most;
    };
    const double u = slope(f.u, (1 + f.u.value) * most), v = slope(f.v, (1 + f.v.value) * most);
    const double n = slope(f.n, f.height);
    const double area = (least - u) * (least - v) - u * v;
    if (!(least > u && least > v && area > 0)) return infinity;
    // The cross product of the tangents in the frame, (a, b, area), is one of `rows` in space.
    const double off =
        n * (f.rows[0].length() * (most + 2 * v) + f.rows[1].length() * (most + 2 * u)) / area;
    return 2 * off / f.rows[2].length() * (1 + 1e-9);
}

/// With its frame and its polynomial.
void append_sub_patch(const SubPatch& sub_patch, const std::vector<Vec4>& points,
                      const SubPatchFrame& frame, SubPatchSet& set) {
    SubPatchPolynomial polynomial;
    polynomial.coefficients.resize(points.size());
    if (frame.regular)
        polynomial = sub_patch_polynomial({sub_patch.degree_u, sub_patch.degree_v, points}, frame);
    set.sub_patches.push_back(sub_patch);
    set.points.insert(set.points.end(), points.begin(), points.end());
    set.frames.push_back(frame);
    set.roundings.push_back(polynomial.rounding);
    set.polynomials.insert(set.polynomials.end(), polynomial.coefficients.begin(),
                           polynomial.coefficients.end());
}

} // namespace

SubPatchMaker::WeightRange SubPatchMaker::weight_range(const std::vector<Vec4>& points) {
    const auto [least, largest] = std::minmax_element(
        points.begin(), points.end(), [](const Vec4& a, const Vec4& b) { return a.w < b.w; });
    return {least->w, largest->w};
}

SubPatchMaker::SubPatchMaker(const BezierPatchView& patch, std::uint32_t index, double reach)
    : index_(index), reach_(reach), origin_(hull_bounds(patch).center()) {
    for (const Vec4& p : patch.points) {
        const Vec3 moved = Vec3(p.x, p.y, p.z) - origin_ * p.w;
        points_.emplace_back(moved.x, moved.y, moved.z, p.w);
    }
    patch_ = {patch.degree_u, patch.degree_v, points_};
    size_ = hull_bounds(patch_).size();
    weights_ = weight_range(points_);
}

bool SubPatchMaker::has_area() const {
    const auto farthest_from = [&](const Vec3& from) {
        return euclidean(
            *std::max_element(points_.begin(), points_.end(), [&](const Vec4& a, const Vec4& b) {
                return (euclidean(a) - from).length() < (euclidean(b) - from).length();
            }));
    };
    const Vec3 first = farthest_from(euclidean(points_.front()));
    const Vec3 way = (farthest_from(first) - first).normalized();
    return std::any_of(points_.begin(), points_.end(), [&](const Vec4& p) {
        return way.cross(euclidean(p) - first).length() > rounding_error(1);
    });
}

void SubPatchMaker::add(const Share& share, const SubPatchFrame& frame, SubPatchSet& set) const {
    check_stop();
    SubPatch sub_patch = sub_patch_of(share, frame);
    sub_patch.first_point = static_cast<std::uint32_t>(set.points.size());
    std::vector<Vec4> points = points_of(sub_patch);
    put_at_center(points, sub_patch);
    const SubPatchFrame own = sub_patch_frame({patch_.degree_u, patch_.degree_v, points});
    sub_patch.seam_reach = sub_patch.domain.extent() * farthest_apart(own, reach_);
    sub_patch.normal_spread = normal_spread(own);
    if (own.regular) sub_patch.normal = own.rows[2].normalized();
    append_sub_patch(sub_patch, points, own, set);
}

SubPatch SubPatchMaker::sub_patch_of(const Share& share, const SubPatchFrame& frame) const {
    SubPatch sub_patch;
    sub_patch.patch = index_;
    sub_patch.degree_u = static_cast<std::uint16_t>(patch_.degree_u);
    sub_patch.degree_v = static_cast<std::uint16_t>(patch_.degree_v);
    sub_patch.near_border = share.near_border;
    sub_patch.trim = share.trim;
    const double error = rounding_error(1);
    const auto slip = [&](double length) {
        return std::min(widest_overlap, overlap + 16 * error / length);
    };
    const Box2& box = share.box;
    sub_patch.slip = box.extent() * Vec2(slip(frame.length.x), slip(frame.length.y));
    sub_patch.domain = {box.lower - sub_patch.slip, box.upper + sub_patch.slip};
    for (unsigned k = 0; k < 2; ++k) {
        if (box.lower[k] <= 0) sub_patch.domain.lower[k] -= beyond_.lower[k];
        if (box.upper[k] >= 1) sub_patch.domain.upper[k] += beyond_.upper[k];
    }
    return sub_patch;
}

/// Control points over its domain, which is cut where it cannot go on past the patch.
std::vector<Vec4> SubPatchMaker::points_of(SubPatch& sub_patch) const {
    std::vector<Vec4> points = subpatch(patch_, sub_patch.domain);
    // Past the patch's end the weights may run down to zero: there is no surface to go on with.
    if (!(weight_range(points).least > weights_.least / 2)) {
        sub_patch.domain =
            sub_patch.domain.intersection({Vec2(0) - sub_patch.slip, Vec2(1) + sub_patch.slip});
        points = subpatch(patch_, sub_patch.domain);
    }
    return points;
}

void SubPatchMaker::put_at_center(std::vector<Vec4>& points, SubPatch& sub_patch) const {
    sub_patch.coefficient_error =
        rounding_error(growth(sub_patch.domain, weight_range(points).least));
    const Vec3 middle = hull_bounds({patch_.degree_u, patch_.degree_v, points}).center();
    sub_patch.center = origin_ + middle;
    sub_patch.weight = 0;
    for (Vec4& p : points) {
        const Vec3 moved = Vec3(p.x, p.y, p.z) - middle * p.w;
        sub_patch.radius = std::max(sub_patch.radius, moved.length() / p.w);
        sub_patch.weight = std::max(sub_patch.weight, p.w);
        p = {moved.x, moved.y, moved.z, p.w};
    }
}

/// mm: bound of what the roundings of making a sub-patch move a control point by. Each of the
/// 2 (degree_u + degree_v) blends that make it costs 3 unit roundoffs of w (P - origin) and as
/// much of w; `growth` as below. The rest is taking off the centres.
double SubPatchMaker::rounding_error(double growth) const {
    const double blends = 6.0 * (patch_.degree_u + patch_.degree_v);
    return epsilon * (8 * origin_.length() + (blends * growth + 8) * size_ / 2);
}

/// How much larger than the sub-patch's own weight the sum of the |terms| of a weight may be: 1
/// where each blend is an average, more where the sub-patch goes on past the patch.
double SubPatchMaker::growth(const Box2& domain, double least) const {
    double beyond = 0;
    for (unsigned k = 0; k < 2; ++k)
        beyond = std::max({beyond, -domain.lower[k], domain.upper[k] - 1});
    const double terms = std::pow(1 + 2 * beyond, 2 * (patch_.degree_u + patch_.degree_v));
    return 1 + (terms - 1) * weights_.largest / least;
}

} // namespace keiko
