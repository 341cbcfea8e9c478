#include "keiko/light/tubes/tube_end_clipper.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Whether a curve bulges away from a side, or not at all.
bool bounds_convex(const LampEnd& end, Side side) {
    return side == Side::before ? end.bulge >= 0 : end.bulge <= 0;
}

/// How far from a unit circle's centre a chord would be that bounds as much as its arc.
double mean_level(double half_chord) {
    constexpr double small = 1e-6;
    if (!(half_chord > small)) return 1;
    return (std::sqrt(1 - half_chord * half_chord) + std::asin(half_chord) / half_chord) / 2;
}

/// By the chords of an arc; `line`(normal, level) of one, so far from the circle's centre.
template <class Line>
ClippedPixel cut_along(const ClippedPixel& part, const Vec2& from, const Vec2& to, int halvings,
                       double level, const Line& line) {
    constexpr double small = 1e-6;
    const Vec2 chord = to - from;
    const double length = chord.length();
    const Vec2 normal = length > small ? Vec2(chord.y, -chord.x) / length : from;
    if (halvings == 0) return part.where(line(normal, level));
    return cut_along(cut_along(part, from, normal, halvings - 1, level, line), normal, to,
                     halvings - 1, level, line);
}

} // namespace

double TubeEndClipper::area(const ClippedPixel& part, double axis, const LampEnd& end,
                            Side side) const {
    if (bounds_convex(end, side)) return cut(part, axis, end, side).area();
    const Side other = side == Side::before ? Side::past : Side::before;
    return std::max(part.area() - cut(part, axis, end, other).area(), 0.0);
}

ClippedPixel TubeEndClipper::cut(const ClippedPixel& part, double axis, const LampEnd& end,
                                 Side side) const {
    const Vec2 from(end.at, axis);
    const double sign = side == Side::before ? 1 : -1, bulge = std::abs(end.bulge);
    const Vec2 inwards(-sign, sign * end.shear / half_);
    const PixelLinear before_chord = image_.past(inwards, from, 0);
    if (part.is_all_where(before_chord)) return part;
    if (bulge == 0) return part.where(before_chord);
    const PixelLinear tangent = image_.past(inwards, from, -bulge);
    if (!part.is_any_where(tangent)) return part.where(tangent);
    const auto line = [&](const Vec2& normal, double level) {
        const Vec2 slope = inwards * normal.x - Vec2(0, normal.y * bulge / half_);
        return image_.past(slope, from, -level * bulge);
    };
    const auto [begin, last] = arc_on(part, axis);
    double half_chord = (last - begin).length() / 2;
    const int halvings = halvings_of(half_chord, bulge);
    return cut_along(part, begin, last, halvings, mean_level(half_chord), line);
}

std::array<Vec2, 2> TubeEndClipper::arc_on(const ClippedPixel& part, double axis) const {
    double low = 1, high = -1;
    for (const Vec2& corner : part) {
        const double q = (image_.v(corner) - axis) / half_;
        low = std::isfinite(q) ? std::min(low, q) : -1;
        high = std::isfinite(q) ? std::max(high, q) : 1;
    }
    // Beside the strip's sides the arc is steep: there the side itself is taken, or rounding of the
    // part's corners would count many times.
    constexpr double steep = 0.99;
    low = low < -steep ? -1 : std::min(low, steep);
    high = high > steep ? 1 : std::max({high, low, -steep});
    return {Vec2(std::sqrt(1 - low * low), low), Vec2(std::sqrt(1 - high * high), high)};
}

int TubeEndClipper::halvings_of(double& half_chord, double bulge) const {
    constexpr double allowed = 1e-3; // of the pixel
    constexpr int most = 4;
    // What is on one side of a chord at its mean level is up to 0.02 times its length cubed.
    const double scale = 8 * 0.02 * half_ * bulge, enough = allowed * image_.least_area();
    int halvings = 0;
    while (halvings < most && scale * half_chord * half_chord * half_chord > enough) {
        half_chord = std::sqrt((1 - std::sqrt(1 - half_chord * half_chord)) / 2);
        ++halvings;
    }
    return halvings;
}

} // namespace keiko
