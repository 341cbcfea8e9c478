#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/render/tiles.h"

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

/// Writes the layers of light. `color`: cd/m2; `illuminance`: lx, both as mean over the pixel or of
/// one sample.
void write_light_aovs(Film& film, int x, int y, const Rgb& color, double illuminance) {
    if (const auto layer = film.aovs.find(Aov::luminance); layer != film.aovs.end())
        put(layer->second, x, y, {luminance(color)});
    if (const auto layer = film.aovs.find(Aov::illuminance); layer != film.aovs.end())
        put(layer->second, x, y, {illuminance});
}

void write_curvature(Image& image, int x, int y, const Hit& hit) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const PrincipalCurvatures k = reliable_curvatures(derivatives_of(hit), hit.normal)
                                      .value_or(PrincipalCurvatures{unknown, unknown});
    put(image, x, y, {k.k1, k.k2, k.mean(), k.gaussian()});
}

void write_aov(Aov aov, Image& image, int x, int y, const PixelSample& sample) {
    const Hit& hit = *sample.hit;
    switch (aov) {
        case Aov::luminance:
        case Aov::illuminance:
            break; // written with the colour
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

void write_aovs(Film& film, int x, int y, const PixelSample& sample) {
    write_light_aovs(film, x, y, sample.luminance, sample.illuminance);
    if (!sample.hit) return;
    for (auto& [aov, image] : film.aovs) write_aov(aov, image, x, y, sample);
}

} // namespace

Film blank_film(int width, int height, std::span<const Aov> aovs) {
    Film film{Image(width, height, 3), Image(width, height, 1), {}};
    for (const Aov aov : aovs)
        film.aovs[aov] =
            Image(width, height, static_cast<int>(channel_names(aov).size()), blank_value(aov));
    return film;
}

void write_row(Film& film, int x, int y, std::span<const PixelSample> samples) {
    float *color = film.color.pixel(x, y), *alpha = film.alpha.pixel(x, y);
    for (const PixelSample& sample : samples) {
        for (const double value : {sample.luminance.r, sample.luminance.g, sample.luminance.b})
            *color++ = static_cast<float>(value);
        *alpha++ = sample.covered ? 1 : 0;
    }
    if (film.aovs.empty()) return;
    for (const PixelSample& sample : samples) write_aovs(film, x++, y, sample);
}

void write_mean(Film& film, int x, int y, std::span<const PixelSample> samples,
                std::span<const double> shares) {
    Rgb color;
    double all = 0, covered = 0, illuminance = 0; // illuminance: of the covered share
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double share = shares[i];
        color += samples[i].luminance * share;
        covered += samples[i].covered ? share : 0;
        illuminance += samples[i].illuminance * share;
        all += share;
    }
    color = color / all;
    put(film.color, x, y, {color.r, color.g, color.b});
    put(film.alpha, x, y, {covered / all});
    write_light_aovs(film, x, y, color, covered > 0 ? illuminance / covered : 0);
}

} // namespace keiko
