#include "keiko/compare/outlines/outline_shift.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// The places of a square grid over a pixel, its borders included, row by row.
std::vector<Vec2> grid_places(int x, int y, std::size_t side) {
    std::vector<Vec2> places;
    const auto cells = static_cast<double>(side - 1);
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i)
            places.emplace_back(x + static_cast<double>(i) / cells,
                                y + static_cast<double>(j) / cells);
    return places;
}

} // namespace

OutlineComparison::OutlineComparison(const OutlineBody& before, const OutlineBody& after,
                                     const Camera& camera, const OutlineTolerance& tolerance,
                                     double reach)
    : before_(before),
      after_(after),
      camera_(camera),
      finder_before_(before, camera),
      finder_after_(after, camera),
      tolerance_(tolerance),
      reach_(reach) {}

double OutlineComparison::allowed(const Vec3& place) const {
    return std::max(tolerance_.distance, tolerance_.pixels * pixel_length(camera_, place));
}

void OutlineComparison::measure(const OutlineBody& body, const Hit& hit, const OutlineBody& other,
                                OutlineShift& worst) const {
    const double distance = distance_to_same(body, hit, other, reach_);
    const double excess = distance / allowed(hit.position);
    if (excess > worst.excess)
        worst = {distance, distance / pixel_length(camera_, hit.position), excess, hit.position};
}

/// Places that the bodies show alike need no search: each is as near to the other as they are
/// apart.
void OutlineComparison::measure_both(const Sighting& before, const Sighting& after,
                                     OutlineShift& worst) const {
    if (before.hit && after.hit && before.name == after.name &&
        (before.hit->position - after.hit->position).length() <= allowed(before.hit->position))
        return;
    if (before.hit) measure(before_, *before.hit, after_, worst);
    if (after.hit) measure(after_, *after.hit, before_, worst);
}

/// The sides that normals point to are left to the faces.
bool OutlineComparison::alike(const Sighting& before, const Sighting& after) const {
    if (!before.hit && !after.hit) return true;
    if (!before.hit || !after.hit || before.name != after.name) return false;
    const Hit &a = *before.hit, &b = *after.hit;
    if (!(before_.paints[a.face] == after_.paints[b.face])) return false;
    const double across = std::abs((b.position - a.position).dot(a.normal));
    const Vec3 other = a.normal.dot(b.normal) < 0 ? -b.normal : b.normal;
    return across <= tolerance_.surface &&
           radians_to_degrees(angle_between(a.normal, other)) <= tolerance_.normal;
}

PixelOutline OutlineComparison::in_pixel(int x, int y, bool finely) const {
    PixelOutline pixel;
    const std::array centre{Vec2(x + 0.5, y + 0.5)};
    measure_both(finder_before_.look(centre).front(), finder_after_.look(centre).front(),
                 pixel.worst);
    if (!pixel.worst.within()) return pixel;
    const std::size_t side = finely ? 17 : 5;
    const std::vector<Vec2> places = grid_places(x, y, side);
    const std::vector<Sighting> before = finder_before_.look(places);
    const std::vector<Sighting> after = finder_after_.look(places);
    pixel.alike = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
        measure_both(before[i], after[i], pixel.worst);
        pixel.alike = pixel.alike && alike(before[i], after[i]);
    }
    const std::vector<Hit> outlines_before = finder_before_.outlines(before, side);
    const std::vector<Hit> outlines_after = finder_after_.outlines(after, side);
    for (const Hit& hit : outlines_before) measure(before_, hit, after_, pixel.worst);
    for (const Hit& hit : outlines_after) measure(after_, hit, before_, pixel.worst);
    pixel.found = !outlines_before.empty() || !outlines_after.empty();
    return pixel;
}

} // namespace keiko
