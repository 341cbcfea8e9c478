#include "keiko/maps/environment.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/maps/panorama.h"
#include "keiko/math/unit_vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

bool is_linear(const std::filesystem::path& file) {
    const std::string extension = lower_case(file.extension().string());
    return extension == ".exr" || extension == ".hdr";
}

/// The faces of a cube map side by side or below each other.
std::vector<PictureTexture> cube_faces(const Image& image, const std::string& file) {
    const bool row = image.width == 6 * image.height;
    if (!row && image.height != 6 * image.width)
        throw Error(file, "",
                    "is no cube map of six squares in a row: " + std::to_string(image.width) +
                        " x " + std::to_string(image.height) + " pixels");
    const int side = std::min(image.width, image.height);
    std::vector<PictureTexture> faces;
    for (int face = 0; face < 6; ++face) {
        Image square(side, side, image.channels);
        for (int y = 0; y < side; ++y) {
            const float* from = row ? image.pixel(face * side, y) : image.pixel(0, face * side + y);
            std::copy_n(from, side * image.channels, square.pixel(0, y));
        }
        faces.emplace_back(square, Wrap::clamp, Wrap::clamp);
    }
    return faces;
}

TexturePlace place_of(const ProjectedPlace& at, const Vec3& dx, const Vec3& dy) {
    const auto change = [&](const Vec3& step) {
        return Vec3(at.grad_u.dot(step), at.grad_v.dot(step), 0);
    };
    return {Vec3(at.at.x, at.at.y, 0), change(dx), change(dy)};
}

/// A place of a panorama. Within 30 degrees of a pole both steps of a pixel run along the rows: it
/// is as wide there as both together, up to all of a turn, and as high.
TexturePlace lat_long_place_of(const Vec3& direction, const Vec3& dx, const Vec3& dy) {
    const TexturePlace place = place_of(lat_long_place(direction), dx, dy);
    if (4 * (direction.x * direction.x + direction.y * direction.y) > direction.length2())
        return place;
    const double turn = std::hypot(place.dx.x, place.dy.x);
    const double rise = std::hypot(place.dx.y, place.dy.y);
    return {place.at, Vec3(std::min(turn, 1.0), 0, 0), Vec3(0, rise, 0)};
}

/// Texels [x0, x1) x [y0, y1) of a picture.
struct TexelBlock {
    int x0, y0, x1, y1;

    Vec2 middle() const { return Vec2(x0 + x1, y0 + y1) / 2.0; }
    Rgb mean(const PictureTexture& picture) const {
        Rgb sum;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) sum += picture.texel_at(x, y);
        return sum / ((x1 - x0) * (y1 - y0));
    }
    /// Share of the picture's square.
    double area(const PictureTexture& picture) const {
        return (x1 - x0) * (y1 - y0) * picture.texel().x * picture.texel().y;
    }
    double lat_long_solid_angle(const PictureTexture& picture) const {
        double sum = 0;
        for (int y = y0; y < y1; ++y)
            sum += keiko::lat_long_solid_angle(picture.width(), picture.height(), y);
        return sum * (x1 - x0);
    }
};

} // namespace

Environment::Environment(const EnvironmentSpec& spec)
    : spec_(spec),
      cosine_(std::cos(spec.azimuth * std::numbers::pi / 180)),
      sine_(std::sin(spec.azimuth * std::numbers::pi / 180)) {
    const Image image = read_linear_image(spec.file, !is_linear(spec.file));
    const bool is_strip = image.width == 6 * image.height || image.height == 6 * image.width;
    if (is_strip && spec.layout != EnvironmentSpec::Layout::cube)
        throw Error(spec.file.string(), "", "is a cube map of six squares: say layout = \"cube\"");
    if (*std::min_element(image.values.begin(), image.values.end()) < 0)
        throw Error(spec.file.string(), "", "a pixel is negative");
    if (spec.layout == EnvironmentSpec::Layout::cube)
        faces_ = cube_faces(image, spec.file.string());
    else
        faces_.emplace_back(image, Wrap::repeat, Wrap::clamp);
    each_texel([&](const Vec3& direction, const Rgb& luminance, double solid_angle) {
        low_orders_.add(direction, luminance, solid_angle);
    });
}

Vec3 Environment::to_world(const Vec3& d) const {
    return {cosine_ * d.x - sine_ * d.y, sine_ * d.x + cosine_ * d.y, d.z};
}

Vec3 Environment::to_picture(const Vec3& d) const {
    return {cosine_ * d.x + sine_ * d.y, cosine_ * d.y - sine_ * d.x, d.z};
}

/// Calls `visit`(unit direction in the world, cd/m2, sr) for blocks of texels, of one texel each in
/// pictures of up to 512 columns.
template <class Visit>
void Environment::each_texel(const Visit& visit) const {
    constexpr int most_columns = 512;
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        const PictureTexture& picture = faces_[face];
        const int width = picture.width(), height = picture.height();
        const int side = (width + most_columns - 1) / most_columns;
        for (int y = 0; y < height; y += side)
            for (int x = 0; x < width; x += side) {
                const TexelBlock block{x, y, std::min(x + side, width), std::min(y + side, height)};
                const Vec2 at = block.middle() * picture.texel();
                const bool cube = faces_.size() > 1;
                visit(to_world(cube ? cube_direction(face, at) : lat_long_direction(at)),
                      block.mean(picture) * spec_.luminance,
                      cube ? cube_solid_angle(at) * block.area(picture)
                           : block.lat_long_solid_angle(picture));
            }
    }
}

Rgb Environment::luminance(const Vec3& direction, const Vec3& dx, const Vec3& dy) const {
    const Vec3 d = to_picture(direction), x = to_picture(dx), y = to_picture(dy);
    // Beside a pole a pixel is up to all of a row wide, and must not be as high.
    constexpr int most_lookups = 512;
    if (faces_.size() == 1)
        return faces_[0].value(lat_long_place_of(d, x, y), most_lookups) * spec_.luminance;
    const CubePlace at = cube_place(d);
    return faces_[at.face].value(place_of(at.at, x, y)) * spec_.luminance;
}

Rgb Environment::blurred(const Vec3& direction, double width) const {
    // A single look-up would smear a panorama about its poles and a cube map at its borders.
    constexpr int half = 2, cells = 2 * half + 1;
    const auto [x, y] = AxesAcross(direction, direction.z < 0 ? -1 : 1);
    const double cell = width / cells;
    Rgb sum;
    for (int i = -half; i <= half; ++i)
        for (int k = -half; k <= half; ++k) {
            const Vec3 off = (x * i + y * k) * cell;
            sum += luminance(direction + off, x * cell, y * cell);
        }
    return sum / (cells * cells);
}

Rgb Environment::irradiance(const Vec3& normal) const {
    return low_orders_.irradiance(normal);
}

Rgb Environment::texel_irradiance(const Vec3& normal) const {
    Rgb sum;
    each_texel([&](const Vec3& direction, const Rgb& luminance, double solid_angle) {
        sum += luminance * (std::max(direction.dot(normal), 0.0) * solid_angle);
    });
    return sum;
}

double Environment::low_order_error() const {
    double largest = 0, deviation = 0;
    for (int i = 0; i < 27; ++i) {
        const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
        const Vec3 axis(x, y, z);
        if (axis == Vec3(0)) continue;
        const Vec3 normal = axis.normalized();
        const double exact = keiko::luminance(texel_irradiance(normal));
        largest = std::max(largest, exact);
        deviation = std::max(deviation, std::abs(keiko::luminance(irradiance(normal)) - exact));
    }
    return largest > 0 ? deviation / largest : 0;
}

} // namespace keiko
