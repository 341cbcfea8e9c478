#include "keiko/light/tubes/tube_penumbra.h"
#include "keiko/math/axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace keiko {
namespace {

/// A disc that faces a point, in chords along the point's horizon.
class FacingCap {
public:
    static std::optional<FacingCap> of(const TubeLamp& lamp, const Vec3& point,
                                       const Vec3& normal) {
        const Vec3 along = (lamp.b - lamp.a).normalized();
        const Vec3 from_a = point - lamp.a, from_b = point - lamp.b;
        // Viewed edge-on a disc contributes nothing, and the light of its chords is rounding.
        constexpr double edge_on = 1e-9; // rad
        if (along.dot(from_a) < -edge_on * from_a.length())
            return FacingCap(lamp.a, along, lamp.diameter / 2, point, normal);
        if (along.dot(from_b) > edge_on * from_b.length())
            return FacingCap(lamp.b, along, lamp.diameter / 2, point, normal);
        return std::nullopt;
    }
    bool above_horizon() const { return lowest_ < std::numbers::pi / 2; }

    /// Angle of the lowest chord above the horizon.
    double lowest() const { return lowest_; }
    bool has_chord(double angle) const { return std::cos(angle) > 1e-9; }
    Segment chord(double angle) const {
        const Vec3 middle = centre_ + up_ * (radius_ * std::sin(angle));
        const Vec3 half = along_chords_ * (radius_ * std::cos(angle));
        return {middle - half, middle + half};
    }
    /// Light of parts of a chord, in the measure of the angle: it is constant along the chord
    /// except for the fourth power of the distance.
    double light(double angle, const IntervalSet& parts) const {
        const Segment line = chord(angle);
        const Vec3 way = line.a - point_, step = line.b - line.a;
        const double length = step.length(), nearest = -way.dot(step) / length;
        const double off = std::sqrt(std::max(way.length2() - nearest * nearest, 1e-300));
        const auto integral = [&](double t) {
            const double l = (t * length - nearest) / off;
            return (l / (1 + l * l) + std::atan(l)) / (2 * off * off * off);
        };
        double sum = 0;
        for (const ParameterInterval& part : parts)
            sum += integral(part.end) - integral(part.begin);
        return sum * std::max(normal_.dot(way), 0.0) * std::cos(angle);
    }

private:
    FacingCap(const Vec3& centre, const Vec3& axis, double radius, const Vec3& point,
              const Vec3& normal)
        : centre_(centre), point_(point), normal_(normal), radius_(radius) {
        const Vec3 rise = normal - axis * axis.dot(normal);
        constexpr double level = 1e-9;
        up_ = rise.length() > level ? rise.normalized() : any_perpendicular(axis).normalized();
        along_chords_ = axis.cross(up_);
        const double slope = normal.dot(up_) * radius, height = normal.dot(centre - point);
        const double lowest = slope > level * radius ? -height / slope : height > 0 ? -1 : 1;
        lowest_ = std::asin(std::clamp(lowest, -1.0, 1.0));
    }

    Vec3 centre_, point_, normal_, up_{0}, along_chords_{0};
    double radius_, lowest_ = 0; ///< angle of the lowest chord above the horizon
};

/// Light of a chord, and the visible part of that.
struct Chord {
    double angle = 0, all = 0, lit = 0;
};

std::vector<Chord> chords_at(const std::vector<double>& angles, const FacingCap& cap,
                             const Visibility& visible) {
    std::vector<Segment> lines;
    for (const double angle : angles)
        if (cap.has_chord(angle)) lines.push_back(cap.chord(angle));
    const std::vector<IntervalSet> seen = visible.intervals(lines);
    auto next = seen.begin();
    std::vector<Chord> chords;
    for (const double angle : angles)
        chords.push_back(cap.has_chord(angle) ? Chord{angle, cap.light(angle, IntervalSet::whole()),
                                                      cap.light(angle, *next++)}
                                              : Chord{angle});
    return chords;
}

/// Interval between neighbouring chords, with the one in the middle.
struct ChordInterval {
    Chord begin, end, middle{};

    double width() const { return end.angle - begin.angle; }
    /// Difference of the trapezoid rules with and without the middle. At the edge of a shadow that
    /// lies along the chords it is a share of the jump, wherever between them the edge is.
    double doubt() const { return std::abs(begin.lit - 2 * middle.lit + end.lit) / 4 * width(); }
    double all() const { return (begin.all + 4 * middle.all + end.all) / 6 * width(); }
    double lit() const { return (begin.lit + 4 * middle.lit + end.lit) / 6 * width(); }
};

std::vector<ChordInterval> first_intervals(const FacingCap& cap, const Visibility& visible) {
    constexpr int count = 16;
    std::vector<double> angles;
    for (int i = 0; i <= count; ++i)
        angles.push_back(cap.lowest() + (std::numbers::pi / 2 - cap.lowest()) * i / count);
    const std::vector<Chord> chords = chords_at(angles, cap, visible);
    std::vector<ChordInterval> intervals;
    for (std::size_t i = 1; i < chords.size(); ++i) intervals.push_back({chords[i - 1], chords[i]});
    return intervals;
}

/// Halves intervals until all are accurate to within `tolerance`.
double share(const FacingCap& cap, const Visibility& visible, double tolerance) {
    constexpr int most_halvings = 20;
    std::vector<ChordInterval> open = first_intervals(cap, visible);
    double allowed = 0, all = 0, lit = 0;
    for (const ChordInterval& interval : open)
        allowed += (interval.begin.all + interval.end.all) / 2 * interval.width();
    allowed *= tolerance / 8; // few intervals are in doubt
    for (int halvings = 0; !open.empty(); ++halvings) {
        std::vector<double> angles;
        for (const ChordInterval& interval : open)
            angles.push_back((interval.begin.angle + interval.end.angle) / 2);
        const std::vector<Chord> middles = chords_at(angles, cap, visible);
        std::vector<ChordInterval> halves;
        for (std::size_t i = 0; i < open.size(); ++i) {
            ChordInterval& interval = open[i];
            interval.middle = middles[i];
            // More chords do not improve a value that is NaN.
            if (!(interval.doubt() > allowed) || halvings == most_halvings)
                all += interval.all(), lit += interval.lit();
            else
                halves.push_back({interval.begin, interval.middle}),
                    halves.push_back({interval.middle, interval.end});
        }
        open = std::move(halves);
    }
    return all > 0 ? std::clamp(lit / all, 0.0, 1.0) : 0;
}

} // namespace

double seen_share_of_cap(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                         const Visibility& visible, double tolerance) {
    const auto cap = FacingCap::of(lamp, point, normal);
    if (!cap) return 1;
    if (!cap->above_horizon()) return 0;
    return share(*cap, visible, tolerance);
}

} // namespace keiko
