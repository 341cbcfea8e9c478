#include "keiko/compare/outlines/outline_difference.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

namespace {

/// A pixel to be measured.
struct DifferingPixel {
    int x = 0, y = 0;
    bool flipped = false;
};

bool is_partly_covered(const Film& film, int x, int y) {
    const float share = *film.alpha.pixel(x, y);
    return share > 0 && share < 1;
}

/// Whether the depth bends between three pixels as it does at a contour.
bool is_discontinuous(float before, float here, float after, double pixel) {
    constexpr double discontinuous = 4; // pixels in depth
    return std::abs(double{before} - 2 * double{here} + double{after}) > discontinuous * pixel;
}

/// Whether an outline may run through a pixel or beside it, by what the pixels around show.
class OutlineMask {
public:
    OutlineMask(const Film& film, const Camera& camera)
        : film_(film),
          camera_(camera),
          face_(film.aovs.at(Aov::face)),
          depth_(film.aovs.at(Aov::depth)) {}

    bool near(int x, int y) const {
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, face_.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, face_.width - 1); ++u)
                if (*face_.pixel(u, v) != *face_.pixel(x, y) || is_partly_covered(film_, u, v))
                    return true;
        return has_contour(x, y);
    }

private:
    bool has_contour(int x, int y) const {
        if (x < 1 || y < 1 || x + 1 >= depth_.width || y + 1 >= depth_.height) return false;
        const float here = *depth_.pixel(x, y);
        const double pixel = camera_.projection == Projection::orthographic
                                 ? camera_.pixel_size()
                                 : camera_.pixel_size() * double{here};
        return is_discontinuous(*depth_.pixel(x - 1, y), here, *depth_.pixel(x + 1, y), pixel) ||
               is_discontinuous(*depth_.pixel(x, y - 1), here, *depth_.pixel(x, y + 1), pixel);
    }

    const Film& film_;
    const Camera& camera_;
    const Image &face_, &depth_;
};

Vec3 normal_at(const Film& film, int x, int y) {
    const float* n = film.aovs.at(Aov::normal).pixel(x, y);
    return {n[0], n[1], n[2]};
}

/// Whether two pictures show nearly the same surface at the centre of a pixel: what surely is
/// another one gets no rays.
bool is_nearly_alike(const Film& before, const Film& after, int x, int y) {
    constexpr double most_tilt = 0.1;   // degrees
    constexpr double most_depth = 0.01; // mm, along the ray; the rounding of floats is less
    const Vec3 a = normal_at(before, x, y), b = normal_at(after, x, y);
    const double depth = std::abs(double{*before.aovs.at(Aov::depth).pixel(x, y)} -
                                  double{*after.aovs.at(Aov::depth).pixel(x, y)});
    return std::abs(a.dot(b)) >= std::cos(degrees_to_radians(most_tilt)) && depth <= most_depth;
}

std::vector<DifferingPixel> differing_pixels(const Film& before, const Film& after,
                                             const FilmDifference& difference,
                                             const Camera& camera) {
    const OutlineMask mask_before(before, camera), mask_after(after, camera);
    std::vector<DifferingPixel> pixels;
    for (int y = 0; y < difference.excess.height; ++y)
        for (int x = 0; x < difference.excess.width; ++x) {
            const float excess = *difference.excess.pixel(x, y);
            if (!(excess > 1)) continue;
            const bool flipped = std::isinf(excess);
            if (flipped || mask_before.near(x, y) || mask_after.near(x, y) ||
                is_nearly_alike(before, after, x, y))
                pixels.push_back({x, y, flipped});
        }
    return pixels;
}

/// Coverage that differs where no outline shows between the places of the coarse grid is looked for
/// between those of the fine one.
PixelOutline measured(const OutlineComparison& outlines, const DifferingPixel& pixel) {
    PixelOutline outline = outlines.in_pixel(pixel.x, pixel.y);
    if (!pixel.flipped || outline.found || !outline.worst.within()) return outline;
    return outlines.in_pixel(pixel.x, pixel.y, true);
}

class Tally {
public:
    explicit Tally(const Image& excess) { found_.left_out = Image(excess.width, excess.height, 1); }

    void add(const DifferingPixel& pixel, const PixelOutline& outline) {
        const bool outlined = pixel.flipped || outline.found;
        if (!outlined && !outline.alike) return; // a surface moved: the layers tell
        float& left_out = *found_.left_out.pixel(pixel.x, pixel.y);
        if (!outlined) {
            ++found_.alike, left_out = 1;
            return;
        }
        const OutlineShift& worst = outline.worst;
        if (worst.within())
            ++found_.excused, left_out = 1;
        else
            ++found_.moved;
        if (worst.excess > found_.worst.excess)
            found_.worst = worst, found_.x = pixel.x, found_.y = pixel.y;
    }
    OutlineDifference result() && { return std::move(found_); }

private:
    OutlineDifference found_;
};

} // namespace

OutlineDifference outline_difference(const OutlineComparison& outlines, const Film& before,
                                     const Film& after, const FilmDifference& difference,
                                     const Camera& camera, const Job& job) {
    const std::vector<DifferingPixel> pixels = differing_pixels(before, after, difference, camera);
    std::vector<PixelOutline> measures(pixels.size());
    constexpr std::size_t chunk = 32;
    parallel_for((pixels.size() + chunk - 1) / chunk, job, "outlines", [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(pixels.size(), (c + 1) * chunk); ++i)
            measures[i] = measured(outlines, pixels[i]);
    });
    Tally tally(difference.excess);
    for (std::size_t i = 0; i < pixels.size(); ++i) tally.add(pixels[i], measures[i]);
    return std::move(tally).result();
}

} // namespace keiko
