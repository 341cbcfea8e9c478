#include "keiko/tubes/cap_penumbra.h"

#include "keiko/math/perpendicular.h"

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
        const double x = along.dot(point - lamp.a);
        if (x < 0) return FacingCap(lamp.a, along, lamp.diameter / 2, point, normal);
        if (along.dot(point - lamp.b) > 0)
            return FacingCap(lamp.b, along, lamp.diameter / 2, point, normal);
        return std::nullopt;
    }
    bool above_horizon() const { return lowest_ < std::numbers::pi / 2; }

    /// Half way up the k-th of `count` steps of the angle at which chords lie.
    double angle(int k, int count) const {
        return lowest_ + (std::numbers::pi / 2 - lowest_) * (k + 0.5) / count;
    }
    Segment chord(double angle) const {
        const Vec3 middle = centre_ + up_ * (radius_ * std::sin(angle));
        const Vec3 half = along_chords_ * (radius_ * std::cos(angle));
        return {middle - half, middle + half};
    }
    /// What parts of a chord bring, in the measure of the angle: it is the same all along it but
    /// for the fourth power of the distance.
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

double share(const FacingCap& cap, const Visible& visible, int count) {
    std::vector<Segment> chords;
    for (int k = 0; k < count; ++k) chords.push_back(cap.chord(cap.angle(k, count)));
    const std::vector<IntervalSet> seen = visible.intervals(chords);
    double all = 0, lit = 0;
    for (int k = 0; k < count; ++k) {
        all += cap.light(cap.angle(k, count), IntervalSet::whole());
        lit += cap.light(cap.angle(k, count), seen[static_cast<std::size_t>(k)]);
    }
    return all > 0 ? lit / all : 0;
}

} // namespace

double seen_share_of_cap(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                         const Visible& visible, double tolerance) {
    const auto cap = FacingCap::of(lamp, point, normal);
    if (!cap) return 1;
    if (!cap->above_horizon()) return 0;
    constexpr int fewest = 8, most = 512;
    double coarse = share(*cap, visible, fewest);
    for (int count = 2 * fewest;; count *= 2) {
        const double fine = share(*cap, visible, count);
        if (std::abs(fine - coarse) <= tolerance || count == most) return fine;
        coarse = fine;
    }
}

} // namespace keiko
