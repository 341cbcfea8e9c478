#include "keiko/spotlight/photometric_web.h"

#include "keiko/base/units.h"

#include <algorithm>
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

namespace {

/// Degrees from the axis towards `side`, a unit vector across it, to where the intensity first
/// falls to `limit`.
double falls_at(const PhotometricWeb& web, const Vec3& side, double limit) {
    const Vec3 axis = web_axis(web.type);
    const auto at = [&](double degrees) {
        const double angle = degrees_to_radians(degrees);
        return intensity(web, axis * std::cos(angle) + side * std::sin(angle));
    };
    constexpr double step = 0.25;
    double low = 0;
    while (low < 180 && at(low) < limit) low += step; // a beam that begins off its axis
    while (low < 180 && at(low) >= limit) low += step;
    double below = std::max(low - step, 0.0);
    if (low >= 180) return 180;
    for (int i = 0; i < 40; ++i) {
        const double middle = (below + low) / 2;
        (at(middle) >= limit ? below : low) = middle;
    }
    return low;
}

} // namespace

double spread_angle(const PhotometricWeb& web, double share, double plane) {
    // Types A and B: the planes of the axis that hold the horizontal (0) and the vertical (90).
    const double turn = degrees_to_radians(plane);
    const Vec3 side = web.type == PhotometricType::c   ? Vec3(std::cos(turn), std::sin(turn), 0)
                      : web.type == PhotometricType::a ? Vec3(0, -std::cos(turn), std::sin(turn))
                                                       : Vec3(std::sin(turn), -std::cos(turn), 0);
    double largest = 0;
    for (double degrees = -180; degrees <= 180; degrees += 0.5) {
        const double angle = degrees_to_radians(degrees);
        largest = std::max(
            largest, intensity(web, web_axis(web.type) * std::cos(angle) + side * std::sin(angle)));
    }
    if (!(largest > 0)) return 0;
    return falls_at(web, side, share * largest) + falls_at(web, -side, share * largest);
}

} // namespace keiko
