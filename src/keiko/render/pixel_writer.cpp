#include "keiko/render/pixel_writer.h"

#include "keiko/patch/differential_geometry.h"

#include <algorithm>
#include <initializer_list>
#include <limits>

namespace keiko {
namespace {

void put(Image& image, int x, int y, std::initializer_list<double> values) {
    std::transform(values.begin(), values.end(), image.pixel(x, y),
                   [](double value) { return static_cast<float>(value); });
}

float blank_value(Aov aov) {
    switch (aov) {
        case Aov::face:
        case Aov::patch:
            return -1;
        case Aov::depth:
            return std::numeric_limits<float>::infinity();
        case Aov::luminance:
        case Aov::normal:
        case Aov::uv:
        case Aov::c_plane_uv:
        case Aov::illuminance:
        case Aov::curvature:
            break;
    }
    return 0;
}

/// What a pixel shows of light, of one sample or in the mean.
struct ShownLight {
    Rgb color;
    double covered = 0;     ///< share of the pixel that shows the model
    double illuminance = 0; ///< lx, of that share
};

void write_light(Film& film, int x, int y, const ShownLight& seen) {
    put(film.color, x, y, {seen.color.r, seen.color.g, seen.color.b});
    put(film.alpha, x, y, {seen.covered});
    if (film.aovs.empty()) return;
    if (const auto layer = film.aovs.find(Aov::luminance); layer != film.aovs.end())
        put(layer->second, x, y, {luminance(seen.color)});
    if (const auto layer = film.aovs.find(Aov::illuminance); layer != film.aovs.end())
        put(layer->second, x, y, {seen.illuminance});
}

void write_curvature(Image& image, int x, int y, const Hit& hit) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const PrincipalCurvatures k = reliable_curvatures(derivatives_of(hit), hit.normal)
                                      .value_or(PrincipalCurvatures{unknown, unknown});
    put(image, x, y, {k.k1, k.k2, k.mean(), k.gaussian()});
}

void write_aov(Aov aov, Image& image, int x, int y, const EyeSample& sample) {
    const Hit& hit = *sample.hit;
    switch (aov) {
        case Aov::luminance:
        case Aov::illuminance:
            break; // go with the colour
        case Aov::normal:
            put(image, x, y, {hit.normal.x, hit.normal.y, hit.normal.z});
            break;
        case Aov::uv:
            put(image, x, y, {hit.uv.x, hit.uv.y});
            break;
        case Aov::face:
            put(image, x, y, {static_cast<double>(hit.face)});
            break;
        case Aov::patch:
            put(image, x, y, {static_cast<double>(hit.patch)});
            break;
        case Aov::depth:
            put(image, x, y, {hit.t});
            break;
        case Aov::c_plane_uv:
            if (sample.c_plane) put(image, x, y, {sample.c_plane->x, sample.c_plane->y});
            break;
        case Aov::curvature:
            write_curvature(image, x, y, hit);
            break;
    }
}

} // namespace

Film blank_film(int width, int height, std::span<const Aov> aovs) {
    Film film{Image(width, height, 3), Image(width, height, 1), {}};
    for (const Aov aov : aovs)
        film.aovs[aov] =
            Image(width, height, static_cast<int>(channel_names(aov).size()), blank_value(aov));
    return film;
}

void write_pixel(Film& film, int x, int y, const EyeSample& sample) {
    write_light(film, x, y, {sample.luminance, sample.covered ? 1.0 : 0.0, sample.illuminance});
    if (!sample.hit) return;
    for (auto& [aov, image] : film.aovs) write_aov(aov, image, x, y, sample);
}

void write_mean(Film& film, int x, int y, std::span<const EyeSample> samples,
                std::span<const double> shares) {
    ShownLight sum;
    double all = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double share = shares[i];
        sum.color += samples[i].luminance * share;
        sum.covered += samples[i].covered ? share : 0;
        sum.illuminance += samples[i].illuminance * share;
        all += share;
    }
    const double lit = sum.covered > 0 ? sum.illuminance / sum.covered : 0;
    write_light(film, x, y, {sum.color / all, sum.covered / all, lit});
}

} // namespace keiko
