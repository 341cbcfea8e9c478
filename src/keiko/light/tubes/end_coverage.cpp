#include "keiko/light/tubes/end_coverage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

// A ray that passes a tube's axis at R q in the cross-section enters the tube R sqrt(1 - q^2)
// before its point nearest to the axis. That point is R q d.y / |d.z| from the plane of the axes.
// Both lengths count along the ray, viewed along the lamps.
LampEnds LampEnds::of_tubes(const CPlaneFrame& frame, const Vec3& d) {
    const double slope = d.x / std::sqrt(d.y * d.y + d.z * d.z);
    const double bulge = frame.radius() * slope, shear = bulge * d.y / std::abs(d.z);
    if (frame.luminous_caps)
        return {{0, shear, -std::abs(bulge)}, {frame.length, shear, std::abs(bulge)}};
    return {{0, shear, bulge}, {frame.length, shear, bulge}};
}

namespace {

/// True if a curve bulges away from a side, or not at all.
bool bounds_convex(const LampEnd& end, Side side) {
    return side == Side::before ? end.bulge >= 0 : end.bulge <= 0;
}

/// Distance from a unit circle's centre of the chord that bounds the same area as its arc.
double mean_level(double half_chord) {
    constexpr double small = 1e-6;
    if (!(half_chord > small)) return 1;
    return (std::sqrt(1 - half_chord * half_chord) + std::asin(half_chord) / half_chord) / 2;
}

/// Clips by the chords of an arc; `line`(normal, level) is the line of one at that distance from
/// the circle's centre.
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
    // Near the strip's sides the arc is steep: there the side itself is used, or rounding of the
    // part's corners would be amplified.
    constexpr double steep = 0.99;
    low = low < -steep ? -1 : std::min(low, steep);
    high = high > steep ? 1 : std::max({high, low, -steep});
    return {Vec2(std::sqrt(1 - low * low), low), Vec2(std::sqrt(1 - high * high), high)};
}

int TubeEndClipper::halvings_of(double& half_chord, double bulge) const {
    constexpr double allowed = 1e-3; // of the pixel
    constexpr int most = 4;
    // The area on one side of a chord at its mean level is up to 0.02 times its length cubed.
    const double scale = 8 * 0.02 * half_ * bulge, enough = allowed * image_.least_area();
    int halvings = 0;
    while (halvings < most && scale * half_chord * half_chord * half_chord > enough) {
        half_chord = std::sqrt((1 - std::sqrt(1 - half_chord * half_chord)) / 2);
        ++halvings;
    }
    return halvings;
}

namespace {

constexpr double pi = std::numbers::pi;

/// The strips of a row in a pixel.
class RowInPixel {
public:
    RowInPixel(const CPlaneFrame& frame, double strip_width, const LampEnds& ends,
               const Vec2& centre, const Footprint& footprint)
        : frame_(frame),
          half_(strip_width / 2),
          ends_(ends),
          image_(centre, footprint),
          cutter_(half_, image_),
          pixel_(image_.before_horizon()) {}

    /// Coverage of strips narrower than the pitch.
    double of_strips_apart() const {
        double sum = 0;
        for_each_lamp([&](double axis, const ClippedPixel& strip) {
            sum += seen_of(cut_convex(strip, axis), axis);
        });
        return sum;
    }
    /// Coverage of strips that overlap: for each lamp the part not hidden by the tube, cap
    /// included, that rays meet right before it. Parts hidden by tubes before that one are hidden
    /// by that one too. (Tubes that shine all over may be processed in either order.)
    double of_overlapping_strips() const {
        double sum = 0;
        for_each_lamp([&](double axis, const ClippedPixel& strip) {
            const ClippedPixel part = cut_convex(strip, axis);
            sum += seen_of(part, axis) - hidden_of(part, axis);
        });
        return std::clamp(sum, 0.0, 1.0);
    }
    /// Coverage of strips too fine to be distinguished, as the mean over their possible positions.
    double of_grey_band() const {
        const int count = ends_.begin.shear == 0 ? 1 : 8;
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            const double q = (i + 0.5) * 2 / count - 1;
            const auto at = [&](const LampEnd& end) {
                return end.at + end.shear * q + pi / 4 * end.bulge;
            };
            const ClippedPixel part = pixel_.where(image_.past({1, 0}, {at(ends_.begin), 0}, 0))
                                          .where(image_.past({-1, 0}, {at(ends_.end), 0}, 0));
            sum += band(part, frame_.pitch / 2);
        }
        return 2 * half_ / frame_.pitch * sum / count;
    }

private:
    double band(const ClippedPixel& part, double beyond) const {
        return image_.between(part, frame_.first - beyond, frame_.last() + beyond).area();
    }
    /// The part of a strip on the lamp's side of its end without a dark cap, or of its begin: it is
    /// convex.
    ClippedPixel cut_convex(const ClippedPixel& strip, double axis) const {
        return ends_.begins_with_cap() ? cutter_.cut(strip, axis, ends_.end, Side::before)
                                       : cutter_.cut(strip, axis, ends_.begin, Side::past);
    }
    /// The area of such a part that is on the lamp's side of its other end too.
    double seen_of(const ClippedPixel& part, double axis) const {
        return ends_.begins_with_cap() ? cutter_.area(part, axis, ends_.begin, Side::past)
                                       : cutter_.area(part, axis, ends_.end, Side::before);
    }
    /// The area of such a part behind the neighbour that rays meet before the lamp.
    double hidden_of(const ClippedPixel& part, double axis) const {
        const bool from_begin = ends_.begins_with_cap();
        const bool is_lesser = from_begin == (ends_.begin.shear > 0);
        const double before = is_lesser ? axis - frame_.pitch : axis + frame_.pitch;
        const double room = frame_.pitch / 2;
        if (before < frame_.first - room || before > frame_.last() + room) return 0;
        const ClippedPixel both = image_.between(part, before - half_, before + half_);
        const ClippedPixel hidden =
            from_begin ? cutter_.cut(both, before, rim(ends_.begin, -1), Side::past)
                       : cutter_.cut(both, before, rim(ends_.end, 1), Side::before);
        return seen_of(hidden, axis);
    }
    /// The half of an end's rim that bulges to greater u, or to lesser.
    static LampEnd rim(const LampEnd& end, double sign) {
        return {end.at, end.shear, sign * std::abs(end.bulge)};
    }
    /// Calls `use`(axis, part of the pixel on the strip) for the lamps in it.
    template <class Use>
    void for_each_lamp(const Use& use) const {
        double low = frame_.last(), high = frame_.first;
        for (const Vec2& corner : pixel_) {
            const double v = image_.v(corner);
            low = std::isfinite(v) ? std::min(low, v) : frame_.first;
            high = std::isfinite(v) ? std::max(high, v) : frame_.last();
        }
        const double first = std::ceil((low - half_ - frame_.first) / frame_.pitch);
        const double last = std::floor((high + half_ - frame_.first) / frame_.pitch);
        for (double i = std::max(first, 0.0); i <= std::min(last, frame_.lamps - 1.0); ++i) {
            const double axis = frame_.axis(static_cast<int>(i));
            use(axis, image_.between(pixel_, axis - half_, axis + half_));
        }
    }

    const CPlaneFrame& frame_;
    double half_;
    const LampEnds& ends_;
    PixelImage image_;
    TubeEndClipper cutter_;
    ClippedPixel pixel_;
};

} // namespace

double end_coverage(const CPlaneFrame& frame, double strip_width, bool resolved,
                    const LampEnds& ends, const Vec2& centre, const Footprint& footprint) {
    if (frame.lamps == 0) return 0;
    const RowInPixel row(frame, strip_width, ends, centre, footprint);
    if (!(strip_width < frame.pitch)) return row.of_overlapping_strips();
    return resolved ? row.of_strips_apart() : row.of_grey_band();
}

} // namespace keiko
