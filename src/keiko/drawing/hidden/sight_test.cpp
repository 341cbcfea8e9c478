#include "keiko/drawing/hidden/sight_test.h"

#include "keiko/math/symmetric_eigen.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// Share of the body's size along the line of sight within which two points are one.
constexpr double same_place = 1e-6;
/// Share of the body's size by which rounding moves the hit of the point itself.
constexpr double itself = 1e-9;
/// Share of the body's size, square to a surface, within which a point lies in it: far more than
/// rounding, and than what exact borders that are one line in space miss each other by.
constexpr double in_surface = 1e-8;
/// Share of the body's size for depths below the surface on which the point itself lies. Its exact
/// curve keeps to that surface: where the line of sight touches it, a double root is farther along
/// the line than same_place, but no deeper than rounding.
constexpr double same_surface = 1e-11;

/// How far apart the faces at each edge of a file may be to count as one, mm, part coordinates.
std::vector<double> seam_widths(const SurfaceModel& model, const Tracer& tracer) {
    std::vector<double> widths(model.edges.size());
    for (std::uint32_t i = 0; i < model.trim_curves.size(); ++i)
        if (const std::uint32_t edge = model.trim_curves[i].edge; edge != no_index)
            widths[edge] = std::max(widths[edge], tracer.seam_width(i));
    return widths;
}

/// By how much each instance stretches lengths at most.
std::vector<double> largest_stretches(const SurfaceModel& model) {
    std::vector<double> stretches;
    for (const Instance& instance : model.instances) {
        const auto& rows = instance.transform.rows;
        SquareMatrix<3> products;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) products[i][j] = rows[i].dot(rows[j]);
        const auto squares = symmetric_eigen(products).values;
        stretches.push_back(std::sqrt(*std::max_element(squares.begin(), squares.end())));
    }
    return stretches;
}

} // namespace

SightTest::SightTest(const SurfaceModel& model, const Tracer& tracer,
                     const ImageProjection& projection)
    : tracer_(tracer),
      projection_(projection),
      size_(tracer.bounds().size()),
      before_(2 * size_ + 1),
      seam_widths_(seam_widths(model, tracer)),
      stretches_(largest_stretches(model)) {}

bool SightTest::hides(const Hit& hit, const Ray& ray, const ModelCurve& curve) const {
    const double length = ray.direction.length();
    const double before =
        (1 - hit.t) * length - hit.position_bound; // within its bound it may lie behind
    const double below = before * std::abs(ray.direction.dot(hit.normal)) / length;
    if (!(before > same_place * size_ + curve.reach)) return false;
    // Within the width of a seam the line may have met this face for the one of the point.
    const double seam = hit.seam ? same_place * size_ + 2 * seam_width(hit) : 0;
    return below > (is_own(hit, curve) ? same_surface : in_surface) * size_ + curve.reach + seam;
}

bool SightTest::is_own(const Hit& hit, const ModelCurve& curve) {
    const PlacedFace face{hit.instance, hit.face};
    return std::find(curve.faces.begin(), curve.faces.end(), face) != curve.faces.end();
}

double SightTest::seam_width(const Hit& hit) const {
    return seam_widths_[*hit.seam] * stretches_[hit.instance];
}

int SightTest::sheets_before(const Vec3& point, const ModelCurve& curve) const {
    const Ray ray = projection_.sight_line(point, before_);
    int sheets = 0;
    for (const Hit& hit : tracer_.all(ray)) sheets += hides(hit, ray, curve) ? 1 : 0;
    if (sheets > 0) return sheets;
    const auto first = tracer_.nearest(ray); // all() may keep the other one of two that overlap
    return first && hides(*first, ray, curve) ? 1 : 0;
}

bool SightTest::visible(const Vec3& point, const ModelCurve& curve) const {
    return sights({&point, 1}, curve).front().visible;
}

std::vector<PointSight> SightTest::sights(std::span<const Vec3> points,
                                          const ModelCurve& curve) const {
    std::vector<Ray> rays;
    for (const Vec3& point : points) rays.push_back(projection_.sight_line(point, before_));
    const std::vector<std::optional<Hit>> first = tracer_.nearest(rays);
    std::vector<PointSight> found(points.size());
    std::vector<std::size_t> open;
    std::vector<Ray> open_rays;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!first[i]) continue;
        found[i].visible = !hides(*first[i], rays[i], curve);
        found[i].by_own = !found[i].visible && is_own(*first[i], curve);
        if (found[i].visible) open.push_back(i), open_rays.push_back(rays[i]);
    }
    const std::vector<std::vector<Hit>> hits = tracer_.all(open_rays);
    for (std::size_t k = 0; k < open.size(); ++k)
        for (const Hit& hit : hits[k]) {
            if (hides(hit, open_rays[k], curve)) found[open[k]].visible = false;
            const double before = (1 - hit.t) * open_rays[k].direction.length();
            if (before > itself * size_ && !has(hit.flags, HitFlags::tangential))
                found[open[k]].sure = false;
        }
    for (PointSight& sight : found) sight.sure |= !sight.visible;
    return found;
}

bool SightTest::visible_beside(const Vec3& point, const ModelCurve& curve) const {
    const CameraAxes& axes = projection_.axes();
    std::vector<Vec3> beside;
    for (const Vec3& way : {axes.right, -axes.right, axes.up, -axes.up})
        beside.push_back(point + way * (same_place * size_));
    const std::vector<PointSight> found = sights(beside, curve);
    return std::any_of(found.begin(), found.end(),
                       [](const PointSight& sight) { return sight.visible; });
}

} // namespace keiko
