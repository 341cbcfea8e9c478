#include "keiko/geometry/trim/patch_material.h"

#include "keiko/geometry/bernstein/de_casteljau.h"
#include "keiko/geometry/bezier/parameter_map.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Ranges of a function of s and of its first two derivatives.
struct Series {
    Interval value, first, second;
};

Series operator/(const Series& a, const Series& b) {
    const Interval value = a.value / b.value;
    const Interval first = (a.first - value * b.first) / b.value;
    return {value, first,
            (a.second - first * b.first * Interval(2.0) - value * b.second) / b.value};
}

/// Ranges of a polynomial, from the hulls of its Bernstein coefficients and of their differences.
Series series_of(const BernsteinField& field) {
    const BernsteinField slope = field.derivative(true);
    return {field.range(), slope.range(), slope.derivative(true).range()};
}

/// A coordinate of the curve less that of its start, times the weight.
BernsteinField coordinate(const std::vector<Vec3>& points, unsigned axis, double start) {
    std::vector<double> coefficients;
    double largest = 0;
    for (const Vec3& p : points) {
        coefficients.push_back(p[axis] - start * p.z);
        largest = std::max(largest, std::abs(p[axis]) + std::abs(start * p.z));
    }
    constexpr double rounding = 4e-16;
    return {static_cast<int>(points.size()) - 1, 0, std::move(coefficients), rounding * largest};
}

BernsteinField weights(const std::vector<Vec3>& points) {
    std::vector<double> coefficients;
    for (const Vec3& p : points) coefficients.push_back(p.z);
    return {static_cast<int>(points.size()) - 1, 0, std::move(coefficients), 0};
}

/// Rates of the local parameter of a box of a patch, from the series of the face's parameter.
/// `patch`: the range of the patch's own parameter over the box.
CurveStretch::Rates through(const ParameterMap& map, const Series& face, const Interval& patch) {
    const ParameterRanges by_patch = parameter_ranges(map, patch);
    const Interval first = face.first / by_patch.first;
    const Interval second = (face.second - by_patch.second * square(first)) / by_patch.first;
    const Interval extent(patch.high - patch.low);
    return {first / extent, second / extent};
}

Vec2 projected(const Vec3& p) {
    return Vec2(p.x, p.y) / p.z;
}

/// Distance from a side of a patch, as a share of the patch, within which a trim curve is assumed
/// to run along it.
constexpr double side_width = 1e-10;

/// The box, with no side much shorter than the other, within the patch.
Box2 rounded_out(const Box2& box) {
    constexpr double least_share = 1.0 / 16, least = 1e-9;
    const Vec2 extent = box.extent();
    const double side = std::max(least, least_share * std::max(extent.x, extent.y));
    Box2 wide = box;
    for (unsigned k = 0; k < 2; ++k) {
        if (extent[k] >= side) continue;
        wide.lower[k] = std::max(0.0, box.center()[k] - side / 2);
        wide.upper[k] = std::min(1.0, wide.lower[k] + side);
        wide.lower[k] = std::min(wide.lower[k], wide.upper[k] - side);
    }
    return wide;
}

} // namespace

CurveStretch::CurveStretch(std::vector<Vec3> points, double share)
    : points_(std::move(points)),
      first_(projected(points_.front())),
      last_(projected(points_.back())),
      share_(share) {}

std::array<CurveStretch, 2> CurveStretch::halves() const {
    auto [left, right] = bernstein_parts(points_);
    return {CurveStretch(std::move(left), share_ / 2), CurveStretch(std::move(right), share_ / 2)};
}

CurveStretch::Rates CurveStretch::rates(const Patch& patch, const PatchHeight& around) const {
    const Series w = series_of(weights(points_));
    const auto series = [&](unsigned axis) {
        return series_of(coordinate(points_, axis, first_[axis])) / w;
    };
    const Box2& box = around.uv();
    const Rates x = through(patch.map_u, series(0), {box.lower.x, box.upper.x});
    const Rates y = through(patch.map_v, series(1), {box.lower.y, box.upper.y});
    const PatchHeight::Slopes f = around.slopes();
    return {f.x * x.first + f.y * y.first,
            f.xx * square(x.first) + f.xy * x.first * y.first * Interval(2.0) +
                f.yy * square(y.first) + f.x * x.second + f.y * y.second};
}

std::vector<CurveStretch> border_of(const SurfaceModel& model, const Face& face) {
    std::vector<CurveStretch> border;
    for (const TrimLoop& loop : model.loops_of(face)) {
        const std::size_t begin = border.size();
        for (std::uint32_t c = 0; c < loop.curve_count; ++c)
            border.emplace_back(model.trim_curve(loop.first_curve + c));
        for (std::size_t k = begin, end = border.size(); k < end; ++k) {
            const Vec2 from = border[k].last(), to = border[k + 1 < end ? k + 1 : begin].first();
            if (from != to) border.emplace_back(from, to);
        }
    }
    return border;
}

PatchMaterial::PatchMaterial(const SurfaceModel& model, std::uint32_t patch,
                             const TrimRegion& trims, const Height& height)
    : model_(model),
      patch_(patch),
      trims_(trims),
      height_(height),
      whole_(model.patch(patch), height),
      domain_(face_box(unit_square)) {
    const Vec2 margin = domain_.extent() * side_width;
    domain_.lower -= margin, domain_.upper += margin;
}

Box2 PatchMaterial::face_box(const Box2& uv) const {
    Box2 box;
    box.extend(model_.face_parameters(patch_, uv.lower));
    box.extend(model_.face_parameters(patch_, uv.upper));
    return box;
}

Vec2 PatchMaterial::to_patch(const Vec2& face_parameters) const {
    const Patch& p = model_.patches[patch_];
    return unit_square.nearest(
        {p.map_u.to_patch(face_parameters.x), p.map_v.to_patch(face_parameters.y)});
}

bool PatchMaterial::contains(const Vec2& uv) const {
    return trims_.contains(model_.face_parameters(patch_, uv));
}

std::optional<double> PatchMaterial::height_at(const Vec2& face_parameters) const {
    if (!domain_.contains(face_parameters)) return std::nullopt;
    const Vec3 place = evaluate(model_.patch(patch_), to_patch(face_parameters), 0).position();
    return std::min(height_.of(place), whole_.upper()); // a height above the upper bound is
                                                        // rounding
}

std::optional<PatchMaterial::Overlap> PatchMaterial::overlap(const CurveStretch& stretch) const {
    const Box2 own = stretch.box(), common = own.intersection(domain_);
    if (common.empty()) return std::nullopt;
    Overlap on{{}, own == common};
    on.uv.extend(to_patch(common.lower));
    on.uv.extend(to_patch(common.upper));
    return on;
}

PatchMaterial::CurveBound PatchMaterial::bound(const CurveStretch& stretch,
                                               const Overlap& overlap) const {
    CurveBound bound{whole_.over(overlap.uv).upper()};
    const auto first = height_at(stretch.first()), last = height_at(stretch.last());
    if (!overlap.whole || !first || !last) return bound;
    const CurveStretch::Rates rates =
        stretch.rates(model_.patches[patch_], whole_.over(rounded_out(overlap.uv)));
    bound.monotone = !rates.first.holds_zero();
    // Nowhere farther above its chord than a parabola with its largest second derivative.
    const double above_chord = std::max(0.0, -rates.second.low) / 8;
    const double by_chord = std::max(*first, *last) + above_chord;
    if (by_chord < bound.upper) bound.upper = by_chord;
    return bound;
}

bool beside_material(const TrimRegion& trims, const CurveStretch& stretch, double s) {
    // Distance from the curve, in face parameters.
    constexpr double aside = 1e-10;
    const auto at = stretch.at(s);
    const Vec2 scale = trims.bounds().extent();
    const Vec2 tangent(at[1].x / scale.x, at[1].y / scale.y);
    const double length = tangent.length();
    if (!(length > 0)) return false;
    const Vec2 step = Vec2(-tangent.y * scale.x, tangent.x * scale.y) * (aside / length);
    return trims.contains(at[0] + step) || trims.contains(at[0] - step);
}

} // namespace keiko
