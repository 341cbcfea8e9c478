#include "keiko/radiosity/hemisphere_directions.h"

#include "keiko/math/unit_vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Evenly distributed bits of a number [Steele2014], figure 16.
std::uint64_t mixed_bits(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

constexpr std::uint32_t top_bit = 0x80000000U;

/// The bits of i in reverse: van der Corput's sequence.
std::uint32_t reversed(std::uint32_t i) {
    std::uint32_t bits = 0;
    for (std::uint32_t v = top_bit; i != 0; i >>= 1U, v >>= 1U)
        if ((i & 1U) != 0) bits ^= v;
    return bits;
}

/// The second coordinate of Sobol's sequence.
std::uint32_t sobol(std::uint32_t i) {
    std::uint32_t bits = 0;
    for (std::uint32_t v = top_bit; i != 0; i >>= 1U, v ^= v >> 1U)
        if ((i & 1U) != 0) bits ^= v;
    return bits;
}

double share(std::uint32_t bits) {
    constexpr double whole = 4294967296.0; // 2^32
    return (bits + 0.5) / whole;
}

/// Place in the unit disc of one in the square: areas keep their ratio [ShirleyChiu1997].
Vec2 on_disc(const Vec2& square) {
    const double x = 2 * square.x - 1, y = 2 * square.y - 1;
    constexpr double eighth = std::numbers::pi / 4;
    if (x == 0 && y == 0) return Vec2(0);
    const bool wide = std::abs(x) > std::abs(y);
    const double radius = wide ? x : y;
    const double angle = wide ? eighth * y / x : 2 * eighth - eighth * x / y;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

} // namespace

HemisphereDirections::HemisphereDirections(std::uint64_t seed) {
    const std::uint64_t bits = mixed_bits(seed);
    first_ = static_cast<std::uint32_t>(bits);
    second_ = static_cast<std::uint32_t>(bits >> 32U);
}

Vec2 HemisphereDirections::place(std::uint32_t i) const {
    return {share(reversed(i) ^ first_), share(sobol(i) ^ second_)};
}

Vec3 HemisphereDirections::direction(std::uint32_t i, const Vec3& normal) const {
    const Vec2 disc = on_disc(place(i));
    const AxesAcross axes(normal, std::copysign(1.0, normal.z));
    const double height = std::sqrt(std::max(0.0, 1 - disc.dot(disc)));
    return axes.x * disc.x + axes.y * disc.y + normal * height;
}

} // namespace keiko
