#include "keiko/light/spotlight/photometric_web.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace keiko {

namespace {

/// The entries around an angle, and its position between them: t in [0, 1].
struct Bracket {
    std::size_t low, high;
    double t;
};

Bracket bracket(const std::vector<double>& angles, double angle) {
    const auto above = std::upper_bound(angles.begin(), angles.end(), angle);
    const auto high = static_cast<std::size_t>(above - angles.begin());
    if (high == angles.size()) return {high - 1, high - 1, 0};
    if (high == 0) return {0, 0, 0};
    const double a = angles[high - 1], b = angles[high];
    return {high - 1, high, (angle - a) / (b - a)};
}

double versine_of(double degrees) {
    const double sine = std::sin(degrees_to_radians(degrees) / 2);
    return 2 * sine * sine;
}

/// Position of an angle between two others, linear in the cosine.
double cosine_share(double a, double b, double angle) {
    const double from = versine_of(a);
    return (versine_of(angle) - from) / (versine_of(b) - from);
}

double blend(double a, double b, double t) {
    return a + (b - a) * t;
}

double around(double degrees) {
    const double turned = std::fmod(degrees, 360);
    return turned < 0 ? turned + 360 : turned;
}

} // namespace

IntensityTable::IntensityTable(std::vector<double> vertical, std::vector<double> horizontal,
                               std::vector<double> values, PlaneSymmetry symmetry,
                               TableInterpolation interpolation)
    : vertical_(std::move(vertical)),
      horizontal_(std::move(horizontal)),
      values_(std::move(values)),
      symmetry_(symmetry),
      interpolation_(interpolation) {
    assert(!vertical_.empty() && !horizontal_.empty());
    assert(values_.size() == vertical_.size() * horizontal_.size());
}

double IntensityTable::folded(double h) const {
    switch (symmetry_) {
        case PlaneSymmetry::none:
            return around(h);
        case PlaneSymmetry::axial:
            return horizontal_.front();
        case PlaneSymmetry::quadrant:
            h = around(h);
            if (h > 180) h = 360 - h;
            return h > 90 ? 180 - h : h;
        case PlaneSymmetry::bilateral:
            h = around(h);
            return h > 180 ? 360 - h : h;
        case PlaneSymmetry::bilateral_across:
            h = around(h);
            return h < 90 || h > 270 ? around(180 - h) : h;
        case PlaneSymmetry::lateral:
            return std::abs(h);
        case PlaneSymmetry::limited:
            return h;
    }
    return h;
}

double IntensityTable::operator()(double v, double h) const {
    if (!(v >= vertical_.front() && v <= vertical_.back())) return 0;
    h = folded(h);
    const bool ends = symmetry_ == PlaneSymmetry::lateral || symmetry_ == PlaneSymmetry::limited;
    if (ends && !(h >= horizontal_.front() && h <= horizontal_.back())) return 0;
    Bracket row = bracket(vertical_, v), plane = bracket(horizontal_, h);
    if (interpolation_ == TableInterpolation::cosine && row.low != row.high)
        row.t = cosine_share(vertical_[row.low], vertical_[row.high], v);
    if (symmetry_ == PlaneSymmetry::none && plane.low == plane.high && horizontal_.size() > 1) {
        // Between the last plane and the first, one full turn later.
        const double last = horizontal_.back(), first = horizontal_.front() + 360;
        const double turned = h < horizontal_.front() ? h + 360 : h;
        plane = {horizontal_.size() - 1, 0, first > last ? (turned - last) / (first - last) : 0};
    }
    const auto of_plane = [&](std::size_t p) {
        return blend(value(p, row.low), value(p, row.high), row.t);
    };
    return blend(of_plane(plane.low), of_plane(plane.high), plane.t);
}

double IntensityTable::largest() const {
    return *std::max_element(values_.begin(), values_.end());
}

double IntensityTable::lit_up_to() const {
    for (std::size_t v = vertical_.size(); v-- > 0;)
        for (std::size_t h = 0; h < horizontal_.size(); ++h)
            if (value(h, v) != 0) return vertical_[std::min(v + 1, vertical_.size() - 1)];
    return 0;
}

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
