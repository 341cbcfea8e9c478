#include "keiko/inspect/regularity/normal_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keiko {
namespace {

/// Box of the control points of a side of a patch.
Box3 side_box(const BezierPatchView& patch, bool by_u, bool upper) {
    Box3 box;
    const int last = by_u ? patch.degree_v : patch.degree_u;
    const int fixed = !upper ? 0 : by_u ? patch.degree_u : patch.degree_v;
    for (int k = 0; k <= last; ++k) {
        box.extend(euclidean(by_u ? patch.point(fixed, k) : patch.point(k, fixed)));
    }
    return box;
}

/// The largest absolute coordinate.
double magnitude(const Vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

NormalPatch::NormalPatch(const SurfaceModel& model, std::uint32_t patch, const Affine& placed,
                         double negligible)
    : placed_(model, patch, placed),
      degree_u_(model.patches[patch].degree_u),
      degree_v_(model.patches[patch].degree_v),
      field_(without_zero_sides(normal_field(view(), placed_.rounding))),
      negligible_(negligible) {
    for (const bool by_u : {true, false})
        for (const bool upper : {false, true}) {
            const Box3 side = side_box(view(), by_u, upper);
            if (side.size() <= negligible) tips_.push_back(placed_.middle + side.center());
        }
}

bool NormalPatch::is_at_tip(const Vec3& place) const {
    return std::any_of(tips_.begin(), tips_.end(),
                       [&](const Vec3& tip) { return (tip - place).length() <= 3 * negligible_; });
}

Vec3 NormalPatch::position(const Vec2& uv) const {
    return placed_.middle + evaluate(view(), uv, 0).position();
}

std::optional<Vec3> NormalPatch::normal(const Vec2& uv) const {
    constexpr double clearly = 100; // times its rounding error
    const Vec3 n = value_at(field_, uv);
    const double rounding = field_[0].rounding() + field_[1].rounding() + field_[2].rounding();
    if (!(n.length() > clearly * rounding)) return std::nullopt;
    return n.normalized();
}

double NormalCell::size() const {
    return hull_bounds(box_.view()).size();
}

Vec3 NormalCell::sum() const {
    Vec3 sum(0);
    for (int i = 0; i <= last(true); ++i)
        for (int j = 0; j <= last(false); ++j) sum += coefficient(i, j);
    return sum;
}

double NormalCell::rounding() const {
    double most = 0;
    for (int i = 0; i <= last(true); ++i)
        for (int j = 0; j <= last(false); ++j) most = std::max(most, magnitude(coefficient(i, j)));
    constexpr double of_product = 4 * std::numeric_limits<double>::epsilon();
    return field_[0].rounding() + field_[1].rounding() + field_[2].rounding() + of_product * most;
}

bool NormalCell::is_regular() const {
    return cone() < std::numbers::pi;
}

double NormalCell::cone() const {
    const Vec3 all = sum();
    if (!(all.length() > 0)) return std::numbers::pi;
    const Vec3 mean = all.normalized();
    const double error = rounding();
    double widest = 0;
    for (int i = 0; i <= last(true); ++i)
        for (int j = 0; j <= last(false); ++j) {
            const Vec3 n = coefficient(i, j);
            if (!(n.dot(mean) > error)) return std::numbers::pi;
            widest = std::max(widest, angle_between(n, mean));
        }
    return widest;
}

/// A normal N is a sum of coefficients c with weights of at least 0. N . axis is at least s times
/// the sum of their lengths, s being the smallest sine of a coefficient. That sum is at least |N|,
/// and at most |N| / t, t being the smallest cosine of a coefficient from the mean direction.
std::optional<double> NormalCell::smallest_sine(const Vec3& axis) const {
    const Vec3 all = sum();
    if (!(all.length() > 0)) return std::nullopt;
    const Vec3 mean = all.normalized();
    double sine = 1, cosine = 1;
    const double error = rounding();
    for (int i = 0; i <= last(true); ++i)
        for (int j = 0; j <= last(false); ++j) {
            const Vec3 c = coefficient(i, j);
            const double along = c.dot(axis) - error, ahead = c.dot(mean) - error;
            if (!(ahead > 0)) return std::nullopt;
            const double length = c.length(); // above the error, as `ahead` is above 0
            cosine = std::min(cosine, ahead / (length + error));
            sine = std::min(sine, along / (along < 0 ? length - error : length + error));
        }
    return std::max(sine < 0 ? sine / cosine : sine, -1.0);
}

std::optional<std::array<Vec2, 2>> NormalCell::turned_corners() const {
    struct Corner {
        Vec2 uv;
        Vec3 normal;
    };
    std::vector<Corner> corners;
    for (const bool right : {false, true})
        for (const bool upper : {false, true})
            corners.push_back(
                {{right ? uv().upper.x : uv().lower.x, upper ? uv().upper.y : uv().lower.y},
                 coefficient(right ? last(true) : 0, upper ? last(false) : 0)});
    for (const Corner& a : corners)
        for (const Corner& b : corners)
            if (a.normal.dot(b.normal) < 0) return std::array{a.uv, b.uv};
    return std::nullopt;
}

double NormalCell::turn(bool by_u) const {
    double most = 0;
    for (int k = 0; k <= last(!by_u); ++k) {
        const Vec3 a = by_u ? coefficient(0, k) : coefficient(k, 0);
        const Vec3 b = by_u ? coefficient(last(true), k) : coefficient(k, last(false));
        most = std::max(most, angle_between(a, b));
    }
    return most;
}

std::array<NormalCell, 2> NormalCell::halves(bool turned, double negligible) const {
    constexpr double much = 0.5;
    const std::array<double, 2> sides = extents();
    bool by_u = sides[0] >= sides[1];
    const double along_u = turn(true), along_v = turn(false);
    const bool by_turn = along_u >= along_v;
    if (!turned && std::max(along_u, along_v) > much && sides[by_turn ? 0 : 1] > negligible)
        by_u = by_turn;
    return halves_across(by_u);
}

std::array<double, 2> NormalCell::extents() const {
    return net_extents(box_.view());
}

std::array<NormalCell, 2> NormalCell::halves_across(bool by_u) const {
    constexpr double share = 0.4811; // not the middle, where folds often lie
    const std::array<PatchBox, 2> boxes = box_.parts(by_u, share);
    std::array<FieldTriple, 2> fields;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<BernsteinField, 2> parts = field_[axis].parts(by_u, share);
        fields[0][axis] = std::move(parts[0]), fields[1][axis] = std::move(parts[1]);
    }
    return {NormalCell(boxes[0], std::move(fields[0])), NormalCell(boxes[1], std::move(fields[1]))};
}

} // namespace keiko
