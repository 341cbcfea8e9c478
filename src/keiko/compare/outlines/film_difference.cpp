#include "keiko/compare/outlines/film_difference.h"

#include "keiko/base/error.h"
#include "keiko/base/units.h"
#include "keiko/film/image_difference.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

std::string size_text(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

/// Also of two that are no numbers.
bool are_alike(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// How far apart two images of a layer are at each pixel, and the sizes that a relative tolerance
/// is a share of.
struct Apart {
    Image distance, size;
};

/// OpenImageIO subtracts numbers. Infinities and values that are no numbers become 0 where they are
/// alike, and infinitely far apart where they are not; pixels to be left out become 0.
void settle(Image& a, Image& b, const Image& left_out) {
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        float &x = a.values[i], &y = b.values[i];
        const bool out = left_out.values[i / static_cast<std::size_t>(a.channels)] > 0;
        if (!out && std::isfinite(x) && std::isfinite(y)) continue;
        x = out || are_alike(x, y) ? 0 : infinity;
        y = 0;
    }
}

Apart apart_by_channel(Image a, Image b, const Image& left_out) {
    settle(a, b, left_out);
    return {largest_difference(a, b), largest_size(a, b)};
}

Vec3 vector_at(const Image& image, std::size_t pixel) {
    const float* v = image.values.data() + 3 * pixel;
    return {v[0], v[1], v[2]};
}

/// In degrees.
Apart apart_by_angle(const Image& a, const Image& b, const Image& left_out) {
    Apart apart{Image(a.width, a.height, 1), Image(a.width, a.height, 1)};
    for (std::size_t i = 0; i < apart.distance.values.size(); ++i) {
        if (left_out.values[i] > 0) continue;
        const double angle = radians_to_degrees(angle_between(vector_at(a, i), vector_at(b, i)));
        apart.distance.values[i] = std::isnan(angle) ? infinity : static_cast<float>(angle);
    }
    return apart;
}

bool covers_alike(float a, float b) {
    constexpr double half_a_sample = 1.0 / 32; // outlines are sampled 4 x 4 times
    return are_alike(a, b) || std::abs(double{a} - double{b}) <= half_a_sample;
}

class FilmComparison {
public:
    FilmComparison(const Film& a, const Film& b, const FilmTolerance& tolerance,
                   const Image* left_out)
        : a_(a), b_(b), tolerance_(tolerance), left_out_(left_out) {
        result_.excess = Image(a.color.width, a.color.height, 1);
        result_.pixels = result_.excess.values.size();
    }

    FilmDifference run() && {
        find_flips();
        layer("color", apart_by_channel(a_.color, b_.color, not_compared_), tolerance_.color);
        aov(Aov::normal, tolerance_.normal, apart_by_angle);
        aov(Aov::uv, tolerance_.uv, apart_by_channel);
        aov(Aov::depth, tolerance_.depth, apart_by_channel);
        aov(Aov::c_plane_uv, tolerance_.c_plane_uv, apart_by_channel);
        return std::move(result_);
    }

private:
    const Image* face(const Film& film) const {
        const auto found = film.aovs.find(Aov::face);
        return found == film.aovs.end() ? nullptr : &found->second;
    }

    void find_flips() {
        const Image *face_a = face(a_), *face_b = face(b_);
        const bool outlines = a_.alpha.channels == 1 && b_.alpha.channels == 1;
        std::size_t excused = 0;
        for (std::size_t i = 0; i < result_.pixels; ++i) {
            if (left_out_ && left_out_->values[i] != 0) {
                ++excused;
                continue;
            }
            const bool outline = outlines && !covers_alike(a_.alpha.values[i], b_.alpha.values[i]);
            const bool other = face_a && face_b && face_a->values[i] != face_b->values[i];
            if (outline)
                ++result_.coverage_flips;
            else if (other)
                ++result_.face_flips;
            if (outline || other) result_.excess.values[i] = infinity;
        }
        const std::size_t flips = result_.coverage_flips + result_.face_flips;
        result_.compared = result_.pixels - flips - excused;
        result_.flips_within = double(flips) <= tolerance_.flips * double(result_.pixels);
        not_compared_ = left_out_ ? larger_of(result_.excess, *left_out_) : result_.excess;
    }

    template <class Measure>
    void aov(Aov aov, const LayerTolerance& tolerance, const Measure& measure) {
        const auto a = a_.aovs.find(aov), b = b_.aovs.find(aov);
        if (a != a_.aovs.end() && b != b_.aovs.end())
            layer(std::string(name_of(aov)), measure(a->second, b->second, not_compared_),
                  tolerance);
    }

    void layer(const std::string& name, const Apart& apart, const LayerTolerance& tolerance) {
        const Image excess =
            in_tolerances(apart.distance, apart.size, tolerance.absolute, tolerance.relative);
        const PixelStatistics times = pixel_statistics(excess, 1);
        const PixelStatistics distances = pixel_statistics(apart.distance, 0);
        const auto compared = static_cast<double>(result_.compared);
        const bool few = static_cast<double>(times.above) <= tolerance.allowed * compared;
        result_.layers.push_back({.layer = name,
                                  .beyond = times.above,
                                  .largest = distances.largest,
                                  .excess = times.largest,
                                  .root_mean_square = over_the_compared(distances.root_mean_square),
                                  .x = times.x,
                                  .y = times.y,
                                  .within = few && times.largest <= std::max(1.0, tolerance.hard)});
        result_.excess = larger_of(result_.excess, excess);
    }

    /// Root mean square over the compared pixels, from that over all pixels, where those left out
    /// are 0.
    double over_the_compared(double root_mean_square) const {
        if (result_.compared == 0) return 0;
        return root_mean_square * std::sqrt(static_cast<double>(result_.pixels) /
                                            static_cast<double>(result_.compared));
    }

    const Film &a_, &b_;
    const FilmTolerance& tolerance_;
    const Image* left_out_;
    FilmDifference result_;
    Image not_compared_;
};

} // namespace

bool FilmDifference::within() const {
    return flips_within && std::all_of(layers.begin(), layers.end(),
                                       [](const LayerDifference& layer) { return layer.within; });
}

FilmDifference film_difference(const Film& a, const Film& b, const FilmTolerance& tolerance,
                               const Image* left_out) {
    if (a.color.width != b.color.width || a.color.height != b.color.height)
        throw Error("", "",
                    "pictures of " + size_text(a.color) + " and " + size_text(b.color) +
                        " pixels cannot be compared");
    return FilmComparison(a, b, tolerance, left_out).run();
}

} // namespace keiko
