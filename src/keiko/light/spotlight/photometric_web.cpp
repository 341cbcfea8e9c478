#include "keiko/light/spotlight/photometric_web.h"

#include "keiko/base/units.h"

#include <cmath>
#include <utility>

namespace keiko {
namespace {

/// Degrees of a direction.
std::pair<double, double> angles_of(PhotometricType type, const Vec3& d) {
    double v = 0, h = 0;
    switch (type) {
        case PhotometricType::a:
            v = std::atan2(d.z, std::hypot(d.x, d.y)), h = std::atan2(-d.y, d.x);
            break;
        case PhotometricType::b:
            v = std::atan2(d.x, -d.z), h = std::atan2(-d.y, std::hypot(d.x, d.z));
            break;
        case PhotometricType::c:
            v = std::atan2(std::hypot(d.x, d.y), -d.z), h = std::atan2(d.y, d.x);
            break;
    }
    return {radians_to_degrees(v), radians_to_degrees(h)};
}

} // namespace

double intensity(const PhotometricWeb& web, const Vec3& direction) {
    const auto [v, h] = angles_of(web.type, direction);
    return web.candela(v, h);
}

Vec3 web_direction(PhotometricType type, double vertical, double horizontal) {
    const double v = degrees_to_radians(vertical), h = degrees_to_radians(horizontal);
    switch (type) {
        case PhotometricType::a:
            return {std::cos(v) * std::cos(h), -std::cos(v) * std::sin(h), std::sin(v)};
        case PhotometricType::b:
            return {std::cos(h) * std::sin(v), -std::sin(h), -std::cos(h) * std::cos(v)};
        case PhotometricType::c:
            break;
    }
    return {std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), -std::cos(v)};
}

Vec3 web_axis(PhotometricType type) {
    return web_direction(type, 0, 0);
}

Vec3 off_axis(PhotometricType type, double degrees, double plane) {
    const double angle = degrees_to_radians(degrees), turn = degrees_to_radians(plane);
    const double c = std::cos(turn), s = std::sin(turn);
    const Vec3 side = type == PhotometricType::c   ? Vec3(c, s, 0)
                      : type == PhotometricType::a ? Vec3(0, -c, s)
                                                   : Vec3(s, -c, 0);
    return web_axis(type) * std::cos(angle) + side * std::sin(angle);
}

} // namespace keiko
