#include "keiko/compare/film_difference.h"

#include "keiko/base/error.h"
#include "keiko/base/units.h"
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

/// Two values that are equal, infinite ones too, or that are both no numbers, do not differ.
double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double difference = std::abs(double{a} - double{b});
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

/// A difference and what it is relative to.
struct Apart {
    double distance = 0, size = 0;
};

Apart apart_by_channel(const float* a, const float* b, int channels) {
    Apart apart;
    for (int c = 0; c < channels; ++c) {
        apart.distance = std::max(apart.distance, distance(a[c], b[c]));
        for (const float value : {a[c], b[c]})
            if (std::isfinite(value)) apart.size = std::max(apart.size, std::abs(double{value}));
    }
    return apart;
}

Apart apart_by_angle(const float* a, const float* b, int) {
    const double angle =
        radians_to_degrees(angle_between(Vec3(a[0], a[1], a[2]), Vec3(b[0], b[1], b[2])));
    return {std::isnan(angle) ? std::numeric_limits<double>::infinity() : angle, 0};
}

using Measure = Apart (*)(const float*, const float*, int);

bool covers_alike(float a, float b) {
    constexpr double half_a_sample = 1.0 / 32; // outlines are sampled 4 x 4 times
    return distance(a, b) <= half_a_sample;
}

class FilmComparison {
public:
    FilmComparison(const Film& a, const Film& b, const FilmTolerance& tolerance)
        : a_(a), b_(b), tolerance_(tolerance) {
        result_.excess = Image(a.color.width, a.color.height, 1);
        result_.pixels = result_.excess.values.size();
    }

    FilmDifference run() && {
        find_flips();
        layer("color", a_.color, b_.color, tolerance_.color, apart_by_channel);
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
        for (std::size_t i = 0; i < result_.pixels; ++i) {
            const bool outline = outlines && !covers_alike(a_.alpha.values[i], b_.alpha.values[i]);
            const bool other = face_a && face_b && face_a->values[i] != face_b->values[i];
            if (outline)
                ++result_.coverage_flips;
            else if (other)
                ++result_.face_flips;
            if (outline || other) result_.excess.values[i] = infinity;
        }
        const std::size_t flips = result_.coverage_flips + result_.face_flips;
        result_.compared = result_.pixels - flips;
        result_.flips_within = double(flips) <= tolerance_.flips * double(result_.pixels);
        flipped_ = result_.excess;
    }

    void aov(Aov aov, const LayerTolerance& tolerance, Measure measure) {
        const auto a = a_.aovs.find(aov), b = b_.aovs.find(aov);
        if (a != a_.aovs.end() && b != b_.aovs.end())
            layer(std::string(name_of(aov)), a->second, b->second, tolerance, measure);
    }

    void layer(const std::string& name, const Image& a, const Image& b,
               const LayerTolerance& tolerance, Measure measure) {
        LayerDifference found{.layer = name};
        double squares = 0;
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                if (*flipped_.pixel(x, y) > 0) continue;
                const Apart apart = measure(a.pixel(x, y), b.pixel(x, y), a.channels);
                const double excess =
                    apart.distance == 0
                        ? 0
                        : apart.distance / (tolerance.absolute + tolerance.relative * apart.size);
                squares += apart.distance * apart.distance;
                found.beyond += excess > 1;
                found.largest = std::max(found.largest, apart.distance);
                if (excess > found.excess) found.excess = excess, found.x = x, found.y = y;
                float& most = *result_.excess.pixel(x, y);
                most = std::max(most, static_cast<float>(excess));
            }
        const auto compared = double(result_.compared);
        found.root_mean_square = compared > 0 ? std::sqrt(squares / compared) : 0;
        found.within = double(found.beyond) <= tolerance.allowed * compared &&
                       found.excess <= std::max(1.0, tolerance.hard);
        result_.layers.push_back(found);
    }

    const Film &a_, &b_;
    const FilmTolerance& tolerance_;
    FilmDifference result_;
    Image flipped_;
};

} // namespace

bool FilmDifference::within() const {
    return flips_within && std::all_of(layers.begin(), layers.end(),
                                       [](const LayerDifference& layer) { return layer.within; });
}

FilmDifference film_difference(const Film& a, const Film& b, const FilmTolerance& tolerance) {
    if (a.color.width != b.color.width || a.color.height != b.color.height)
        throw Error("", "",
                    "pictures of " + size_text(a.color) + " and " + size_text(b.color) +
                        " pixels cannot be compared");
    return FilmComparison(a, b, tolerance).run();
}

} // namespace keiko
