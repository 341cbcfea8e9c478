#include "keiko/maps/low_order_light.h"

#include <algorithm>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

/// Products of the components of w, less their means: xx, yy, zz, xy, xz, yz.
std::array<double, 6> second_order(const Vec3& w) {
    constexpr double mean = 1.0 / 3;
    return {w.x * w.x - mean, w.y * w.y - mean, w.z * w.z - mean, w.x * w.y, w.x * w.z, w.y * w.z};
}

} // namespace

void LowOrderLight::add(const Vec3& direction, const Rgb& luminance, double solid_angle) {
    const Rgb light = luminance * (solid_angle / (4 * pi));
    mean_ += light;
    for (int i = 0; i < 3; ++i) slope_[static_cast<std::size_t>(i)] += light * (3 * direction[i]);
    const std::array<double, 6> products = second_order(direction);
    for (std::size_t i = 0; i < products.size(); ++i) bend_[i] += light * (7.5 * products[i]);
}

/// The cosine over the hemisphere weighs the orders by pi, 2 pi / 3 and pi / 4.
Rgb LowOrderLight::irradiance(const Vec3& normal) const {
    Rgb sum = mean_;
    for (int i = 0; i < 3; ++i) sum += slope_[static_cast<std::size_t>(i)] * (normal[i] * 2 / 3);
    const std::array<double, 6> products = second_order(normal);
    for (std::size_t i = 0; i < products.size(); ++i)
        sum += bend_[i] * (products[i] * (i < 3 ? 0.25 : 0.5));
    const auto light = [](double x) { return std::max(pi * x, 0.0); };
    return {light(sum.r), light(sum.g), light(sum.b)};
}

} // namespace keiko
