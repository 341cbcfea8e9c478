#include "keiko/geometry/seam/boundary_curves.h"

#include "keiko/math/polygon.h"

namespace keiko {
namespace {

using Polygon = std::vector<Vec2>;

/// Number of samples of a curve; enough for the sign of a loop's area and for the nesting of loops,
/// its only uses.
constexpr int samples_per_curve = 16;

Polygon polygon_of(const SurfaceModel& model, const TrimLoop& loop) {
    Polygon polygon;
    for (std::uint32_t c = loop.first_curve; c < loop.first_curve + loop.curve_count; ++c) {
        const int samples = model.trim_curves[c].degree == 1 ? 1 : samples_per_curve;
        for (int i = 0; i < samples; ++i)
            polygon.push_back(evaluate(model.trim_curve(c), double(i) / samples, 0)[0]);
    }
    return polygon;
}

double signed_area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i] - polygon[0];
        const Vec2 b = polygon[(i + 1) % polygon.size()] - polygon[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

Box2 box_of(const Polygon& polygon) {
    Box2 box;
    for (const Vec2& p : polygon) box.extend(p);
    return box;
}

/// True if a loop lies inside another one by the majority of a few of its points, since loops may
/// touch.
bool mostly_inside(const Polygon& inner, const Polygon& outer, const Box2& outer_box) {
    constexpr std::size_t voters = 9;
    std::size_t votes = 0;
    for (std::size_t i = 0; i < voters; ++i) {
        const Vec2& p = inner[i * inner.size() / voters];
        votes += outer_box.contains(p) && holds(outer, p);
    }
    return 2 * votes > voters;
}

/// Sides of a face's loops: true if the material is on the left, by the even-odd rule.
std::vector<bool> loop_sides(const SurfaceModel& model, const Face& face) {
    std::vector<Polygon> polygons;
    for (const TrimLoop& loop : model.loops_of(face)) polygons.push_back(polygon_of(model, loop));
    std::vector<Box2> boxes;
    for (const Polygon& polygon : polygons) boxes.push_back(box_of(polygon));
    std::vector<bool> sides;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        bool material_inside = true;
        for (std::size_t j = 0; j < polygons.size(); ++j)
            if (i != j && mostly_inside(polygons[i], polygons[j], boxes[j]))
                material_inside = !material_inside;
        sides.push_back((signed_area(polygons[i]) > 0) == material_inside);
    }
    return sides;
}

/// Sides of a domain, anticlockwise: the material is on the left.
std::array<Vec3, 8> natural_sides(const Box2& domain) {
    const Vec3 a(domain.lower.x, domain.lower.y, 1), b(domain.upper.x, domain.lower.y, 1);
    const Vec3 c(domain.upper.x, domain.upper.y, 1), d(domain.lower.x, domain.upper.y, 1);
    return {a, b, b, c, c, d, d, a};
}

} // namespace

BoundaryCurves::BoundaryCurves(const SurfaceModel& model)
    : model_(&model),
      material_left_(model.trim_curves.size()),
      loops_(model.trim_curves.size()),
      natural_index_(model.faces.size(), no_index) {
    for (std::size_t f = 0; f < model.faces.size(); ++f) {
        const Face& face = model.faces[f];
        grids_.emplace_back(model, face);
        if (face.loop_count == 0) {
            natural_index_[f] = static_cast<std::uint32_t>(natural_points_.size());
            natural_points_.push_back(natural_sides(grids_.back().domain()));
        }
        const std::vector<bool> sides = loop_sides(model, face);
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const TrimLoop& loop = model.loops_of(face)[i];
            for (std::uint32_t c = 0; c < loop.curve_count; ++c) {
                material_left_[loop.first_curve + c] = sides[i];
                loops_[loop.first_curve + c] = loop;
            }
        }
    }
}

std::vector<std::vector<BoundaryInterval>> BoundaryCurves::loops() const {
    std::vector<std::vector<BoundaryInterval>> result;
    const auto add = [&](std::uint32_t instance, std::uint32_t face, const TrimLoop& loop) {
        if (loop.curve_count == 0) return;
        result.emplace_back();
        for (std::uint32_t c = 0; c < loop.curve_count; ++c)
            result.back().push_back({instance, face, loop.first_curve + c, 0, 1});
    };
    for (std::uint32_t i = 0; i < model_->instances.size(); ++i) {
        const Part& part = model_->parts[model_->instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            const Face& face = model_->faces[f];
            if (face.patch_count == 0) continue;
            if (face.loop_count == 0) add(i, f, {natural_side, 4});
            for (const TrimLoop& loop : model_->loops_of(face)) add(i, f, loop);
        }
    }
    return result;
}

std::vector<BoundaryInterval> BoundaryCurves::all() const {
    std::vector<BoundaryInterval> result;
    for (const auto& loop : loops()) result.insert(result.end(), loop.begin(), loop.end());
    return result;
}

BoundaryInterval BoundaryCurves::beside(const BoundaryInterval& interval, bool after) const {
    const std::uint32_t curve = interval.curve;
    const TrimLoop loop = curve < natural_side ? loops_[curve] : TrimLoop{natural_side, 4};
    const std::uint32_t step = after ? 1 : loop.curve_count - 1;
    const std::uint32_t next = (curve - loop.first_curve + step) % loop.curve_count;
    return {interval.instance, interval.face, loop.first_curve + next, 0, 1};
}

SurfaceCurve BoundaryCurves::curve(const BoundaryInterval& interval) const {
    const PatchGrid& grid = grids_[interval.face];
    const Affine& transform = model_->instances[interval.instance].transform;
    if (interval.curve < natural_side)
        return {*model_, grid, transform, model_->trim_curve(interval.curve),
                material_left_[interval.curve]};
    const std::array<Vec3, 8>& lines = natural_points_[natural_index_[interval.face]];
    const std::size_t first = 2 * std::size_t{interval.curve - natural_side};
    return {*model_, grid, transform, {std::span(lines).subspan(first, 2)}, true};
}

double BoundaryCurves::way_over_face(const BoundaryInterval& a, double t, const BoundaryInterval& b,
                                     double s) const {
    const Vec2 from = curve(a).parameters(t), to = curve(b).parameters(s);
    const std::array<Vec3, 2> path{Vec3(from.x, from.y, 1), Vec3(to.x, to.y, 1)};
    const Affine& placed = model_->instances[a.instance].transform;
    return SurfaceCurve(*model_, grids_[a.face], placed, {path}, true).length(0, 1);
}

} // namespace keiko
