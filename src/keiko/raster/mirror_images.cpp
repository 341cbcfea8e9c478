#include "keiko/raster/mirror_images.h"

#include "keiko/base/units.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/raster/mesh_errors.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double dark = 0.02, beside = 0.35; // linear, of a surface and of what is beside it

double shown(const MirrorPixel& pixel) {
    return pixel.face == 0 ? beside : std::max(dark, pixel.coverage);
}

void put(Image& image, int x, int y, const Rgb& linear) {
    float* pixel = image.pixel(x, y);
    pixel[0] = static_cast<float>(srgb_oetf(linear.r));
    pixel[1] = static_cast<float>(srgb_oetf(linear.g));
    pixel[2] = static_cast<float>(srgb_oetf(linear.b));
}

/// A picture whose pixels are `color`(x, y), linear.
template <class Color>
Image image_of(const MirrorPicture& picture, const Color& color) {
    Image image(picture.width, picture.height, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) put(image, x, y, color(x, y));
    return image;
}

double coverage_error(const MirrorPixel& truth, const MirrorPixel& mesh) {
    return is_compared(truth, mesh) ? std::abs(mesh.coverage - truth.coverage) : 0;
}

/// The sum of errors in the square from a pixel on.
double sum_from(const MirrorPicture& truth, const MirrorPicture& mesh, int left, int top,
                int side) {
    double sum = 0;
    for (int y = top; y < std::min(top + side, truth.height); ++y)
        for (int x = left; x < std::min(left + side, truth.width); ++x)
            sum += coverage_error(truth.at(x, y), mesh.at(x, y));
    return sum;
}

} // namespace

Image mirror_image(const MirrorPicture& picture) {
    return image_of(picture, [&](int x, int y) { return Rgb(shown(picture.at(x, y))); });
}

Image wrong_image(const MirrorPicture& truth, const MirrorPicture& mesh) {
    constexpr double dimmed = 0.15;
    const Rgb red(0.8, 0.02, 0.02), blue(0.05, 0.15, 0.9);
    return image_of(truth, [&](int x, int y) {
        const MirrorPixel &a = truth.at(x, y), &b = mesh.at(x, y);
        if (a.face != b.face) return blue;
        const double off = coverage_error(a, b);
        const Rgb plain(dimmed * shown(a));
        return off > wrong_coverage ? plain * (1 - off) + red * off : plain;
    });
}

std::optional<Vec2> most_wrong_place(const MirrorPicture& truth, const MirrorPicture& mesh,
                                     double side) {
    const int whole = std::max(static_cast<int>(side), 2);
    double most = 0;
    std::optional<Vec2> place;
    for (int top = 0; top < truth.height; top += whole / 2)
        for (int left = 0; left < truth.width; left += whole / 2) {
            const double sum = sum_from(truth, mesh, left, top, whole);
            if (!(sum > most)) continue;
            most = sum, place = Vec2(left + whole / 2.0, top + whole / 2.0);
        }
    return place;
}

Camera magnified(const Camera& camera, const Vec2& place, int side, double factor) {
    const Vec2 middle = Vec2(camera.width / 2.0, camera.height / 2.0) + camera.shift;
    const double plane_height = camera.pixel_size() / factor * side;
    Camera nearer = camera;
    nearer.width = nearer.height = side;
    nearer.shift = (middle - place) * factor;
    nearer.orthographic_height = plane_height;
    nearer.vertical_fov = radians_to_degrees(2 * std::atan(plane_height / 2));
    return nearer;
}

} // namespace keiko
