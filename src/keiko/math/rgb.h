#pragma once

#include "keiko/base/export.h"

#include <algorithm>

namespace KEIKO_API keiko {

/// Three linear channels with Rec. 709 primaries [BT.709], scaled so that luminance(rgb) is the
/// photometric quantity itself (cd/m2, lx, cd). A colour without unit multiplies one.
struct Rgb {
    double r = 0, g = 0, b = 0; ///< channels of the Rec. 709 primaries

    constexpr Rgb() = default;
    /// Colour of three channels.
    constexpr Rgb(double red, double green, double blue) : r(red), g(green), b(blue) {}
    /// Colour of three equal channels.
    constexpr explicit Rgb(double grey) : r(grey), g(grey), b(grey) {}

    /// Adds a colour.
    constexpr Rgb& operator+=(const Rgb& o) { return *this = *this + o; }
    /// Multiplies channel by channel.
    constexpr Rgb& operator*=(const Rgb& o) { return *this = *this * o; }
    /// Multiplies by a factor.
    constexpr Rgb& operator*=(double s) { return *this = *this * s; }

    /// Sum, channel by channel.
    friend constexpr Rgb operator+(const Rgb& left, const Rgb& right) {
        return {left.r + right.r, left.g + right.g, left.b + right.b};
    }
    /// Difference, channel by channel.
    friend constexpr Rgb operator-(const Rgb& left, const Rgb& right) {
        return {left.r - right.r, left.g - right.g, left.b - right.b};
    }
    /// Product, channel by channel.
    friend constexpr Rgb operator*(const Rgb& left, const Rgb& right) {
        return {left.r * right.r, left.g * right.g, left.b * right.b};
    }
    /// Multiple of a colour.
    friend constexpr Rgb operator*(const Rgb& a, double s) { return {a.r * s, a.g * s, a.b * s}; }
    /// Multiple of a colour.
    friend constexpr Rgb operator*(double s, const Rgb& a) { return a * s; }
    /// Colour divided by a number.
    friend constexpr Rgb operator/(const Rgb& a, double s) { return {a.r / s, a.g / s, a.b / s}; }
    constexpr bool operator==(const Rgb&) const = default; ///< True if all channels are equal.
};

/// Y of a linear Rec. 709 triple.
constexpr double luminance(const Rgb& c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

/// The largest of the channels.
constexpr double max_channel(const Rgb& c) {
    return std::max({c.r, c.g, c.b});
}

} // namespace keiko
