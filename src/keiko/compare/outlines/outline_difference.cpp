#include "keiko/compare/outlines/outline_difference.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
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
