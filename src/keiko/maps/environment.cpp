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

} // namespace

Environment::Environment(const EnvironmentSpec& spec)
    : spec_(spec),
      cosine_(std::cos(spec.azimuth * std::numbers::pi / 180)),
      sine_(std::sin(spec.azimuth * std::numbers::pi / 180)) {
    const Image image = read_linear_image(spec.file, !is_linear(spec.file));
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

/// Calls `visit`(unit direction in the world, cd/m2, sr).
template <class Visit>
void Environment::each_texel(const Visit& visit) const {
    const bool cube = faces_.size() > 1;
    for (std::size_t face = 0; face < faces_.size(); ++face) {
        const PictureTexture& picture = faces_[face];
        const Vec2 texel = picture.texel();
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const Vec2 at((x + 0.5) * texel.x, (y + 0.5) * texel.y);
                const double solid_angle =
                    cube ? cube_solid_angle(at) * texel.x * texel.y
                         : lat_long_solid_angle(picture.width(), picture.height(), y);
                visit(to_world(cube ? cube_direction(face, at) : lat_long_direction(at)),
                      picture.texel_at(x, y) * spec_.luminance, solid_angle);
            }
    }
}

Rgb Environment::luminance(const Vec3& direction, const Vec3& dx, const Vec3& dy) const {
    const Vec3 d = to_picture(direction), x = to_picture(dx), y = to_picture(dy);
    if (faces_.size() == 1)
        return faces_[0].value(place_of(lat_long_place(d), x, y)) * spec_.luminance;
    const CubePlace at = cube_place(d);
    return faces_[at.face].value(place_of(at.at, x, y)) * spec_.luminance;
}

Rgb Environment::blurred(const Vec3& direction, double width) const {
    const auto [x, y] = AxesAcross(direction, direction.z < 0 ? -1 : 1);
    return luminance(direction, x * width, y * width);
}

Rgb Environment::irradiance(const Vec3& normal) const {
    return low_orders_.irradiance(normal);
}

Rgb Environment::texel_irradiance(const Vec3& normal) const {
    Rgb sum;
    each_texel([&](const Vec3& direction, const Rgb& luminance, double solid_angle) {
        const double cosine = direction.dot(normal);
        if (cosine > 0) sum += luminance * (cosine * solid_angle);
    });
    return sum;
}

double Environment::low_order_error() const {
    double largest = 0, deviation = 0;
    for (int i = 0; i < 27; ++i) {
        const Vec3 normal(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (normal == Vec3(0)) continue;
        const double exact = keiko::luminance(texel_irradiance(normal.normalized()));
        const double low = keiko::luminance(irradiance(normal.normalized()));
        largest = std::max(largest, exact);
        deviation = std::max(deviation, std::abs(low - exact));
    }
    return largest > 0 ? deviation / largest : 0;
}

} // namespace keiko
