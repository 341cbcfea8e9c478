#include "keiko/drawing/hidden/sight_test.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Share of the body's size within which a point lies in a surface: far more than rounding, and
/// than what exact borders that are one line in space miss each other by.
constexpr double same_place = 1e-6;
/// Share of the body's size for depths below the surface on which the point itself lies. Its exact
/// curve keeps to that surface: where the line of sight touches it, a double root is farther along
/// the line than same_place, but no deeper than rounding.
constexpr double same_surface = 1e-11;

} // namespace

SightTest::SightTest(const Tracer& tracer, const ImageProjection& projection)
    : tracer_(tracer),
      projection_(projection),
      size_(tracer.bounds().size()),
      before_(2 * size_ + 1) {}

bool SightTest::hides(const Hit& hit, const Ray& ray, const ModelCurve& curve) const {
    const double length = ray.direction.length(), before = (1 - hit.t) * length;
    const double below = before * std::abs(ray.direction.dot(hit.normal)) / length;
    const PlacedFace face{hit.instance, hit.face};
    const bool own = std::find(curve.faces.begin(), curve.faces.end(), face) != curve.faces.end();
    if (!own) return below > same_place * size_;
    return before > same_place * size_ + curve.reach && below > same_surface * size_ + curve.reach;
}

int SightTest::sheets_before(const Vec3& point, const ModelCurve& curve) const {
    const Ray ray = projection_.sight_line(point, before_);
    int sheets = 0;
    for (const Hit& hit : tracer_.all(ray)) sheets += hides(hit, ray, curve) ? 1 : 0;
    return sheets;
}

bool SightTest::visible(const Vec3& point, const ModelCurve& curve) const {
    const Ray ray = projection_.sight_line(point, before_);
    const auto first = tracer_.nearest(ray);
    if (!first) return true;
    return !hides(*first, ray, curve) && sheets_before(point, curve) == 0;
}

} // namespace keiko
