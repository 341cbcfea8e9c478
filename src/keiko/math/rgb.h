#pragma once

#include <algorithm>

namespace keiko {

/// Three linear channels with Rec. 709 primaries [BT.709], scaled so that luminance(rgb) is the
/// photometric quantity itself (cd/m2, lx, cd). A colour without unit multiplies one.
struct Rgb {
    double r = 0, g = 0, b = 0;

    constexpr Rgb() = default;
    constexpr Rgb(double red, double green, double blue) : r(red), g(green), b(blue) {}
    constexpr explicit Rgb(double grey) : r(grey), g(grey), b(grey) {}

    constexpr Rgb& operator+=(const Rgb& o) { return *this = *this + o; }
    constexpr Rgb& operator*=(const Rgb& o) { return *this = *this * o; }
    constexpr Rgb& operator*=(double s) { return *this = *this * s; }

    friend constexpr Rgb operator+(const Rgb& left, const Rgb& right) {
        return {left.r + right.r, left.g + right.g, left.b + right.b};
    }
    friend constexpr Rgb operator-(const Rgb& left, const Rgb& right) {
        return {left.r - right.r, left.g - right.g, left.b - right.b};
    }
    friend constexpr Rgb operator*(const Rgb& left, const Rgb& right) {
        return {left.r * right.r, left.g * right.g, left.b * right.b};
    }
    friend constexpr Rgb operator*(const Rgb& a, double s) { return {a.r * s, a.g * s, a.b * s}; }
    friend constexpr Rgb operator*(double s, const Rgb& a) { return a * s; }
    friend constexpr Rgb operator/(const Rgb& a, double s) { return {a.r / s, a.g / s, a.b / s}; }
    constexpr bool operator==(const Rgb&) const = default;
};

/// Y of a linear Rec. 709 triple.
constexpr double luminance(const Rgb& c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

constexpr double max_channel(const Rgb& c) {
    return std::max({c.r, c.g, c.b});
}

} // namespace keiko
