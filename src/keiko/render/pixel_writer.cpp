#include "keiko/render/pixel_writer.h"

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
            break;
    }
    return 0;
}

void write_color(Film& film, int x, int y, const Rgb& color, double alpha) {
    put(film.color, x, y, {color.r, color.g, color.b});
    put(film.alpha, x, y, {alpha});
    if (const auto layer = film.aovs.find(Aov::luminance); layer != film.aovs.end())
        put(layer->second, x, y, {luminance(color)});
}

void write_aov(Aov aov, Image& image, int x, int y, const EyeSample& sample) {
    const Hit& hit = *sample.hit;
    switch (aov) {
        case Aov::luminance:
            break; // goes with the colour
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
    write_color(film, x, y, sample.luminance, sample.hit ? 1 : 0);
    if (!sample.hit) return;
    for (auto& [aov, image] : film.aovs) write_aov(aov, image, x, y, sample);
}

void write_mean(Film& film, int x, int y, std::span<const EyeSample> samples) {
    Rgb sum;
    double covered = 0;
    for (const EyeSample& sample : samples) {
        sum += sample.luminance;
        covered += sample.hit ? 1 : 0;
    }
    const auto count = static_cast<double>(samples.size());
    write_color(film, x, y, sum / count, covered / count);
}

} // namespace keiko
