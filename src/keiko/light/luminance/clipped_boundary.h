#pragma once

#include "keiko/light/luminance/rim.h"
#include "keiko/math/vec.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace keiko {

/// Stokes' integral along a closed boundary of straight edges and parts of rims that is clipped to
/// the horizon of a surface element piece by piece, without storage. Pieces follow each other. All
/// vectors are relative to the point.
class ClippedBoundary {
public:
    /// `normal`: the unit normal of the surface element.
    explicit ClippedBoundary(const Vec3& normal) : normal_(normal) {}

    /// Adds a straight edge.
    void add_edge(const Vec3& a, const Vec3& b) {
        const double ha = normal_.dot(a), hb = normal_.dot(b);
        const bool a_above = ha >= 0, b_above = hb >= 0;
        go_on(a_above, a);
        last_above_ = b_above;
        if (!a_above && !b_above) return;
        if (a_above && b_above) return add_arc(a, b);
        const Vec3 crossing = a + (b - a) * (ha / (ha - hb));
        if (a_above) {
            add_arc(a, crossing);
            leave(crossing);
        } else {
            enter(crossing);
            add_arc(crossing, b);
        }
    }

    /// Adds a part of a rim, rising or falling; see Rim::arc.
    void add_rim(const Rim& rim, double begin, double end) {
        std::array<double, 4> stops{};
        const std::size_t count = stops_of(rim, begin, end, stops);
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const double from = stops[i], to = stops[i + 1];
            const bool above = rim.height((from + to) / 2) >= 0;
            go_on(above, rim.at(from));
            last_above_ = above;
            if (above) sum_ += rim.arc(from, to);
        }
    }

    /// Half of the integral along the closed boundary above the horizon, signed by its orientation.
    double closed() {
        if (outside_) add_horizon_arc(exit_, first_entry_);
        return sum_ / 2;
    }

private:
    void add_arc(const Vec3& a, const Vec3& b) {
        const Vec3 plane = a.cross(b);
        const double sine = plane.length();
        if (sine > 0) sum_ += std::atan2(sine, a.dot(b)) * normal_.dot(plane) / sine;
    }

    /// Adds the side in the horizon in full: its great circle has the normal +-N. The signed angle
    /// about N stays right where the crossings nearly coincide.
    void add_horizon_arc(const Vec3& a, const Vec3& b) {
        sum_ += std::atan2(normal_.dot(a.cross(b)), a.dot(b));
    }

    void leave(const Vec3& crossing) {
        exit_ = crossing;
        outside_ = true;
    }
    void enter(const Vec3& crossing) {
        if (outside_) {
            add_horizon_arc(exit_, crossing);
        } else {
            first_entry_ = crossing; // its exit is the last one, met when the boundary closes
        }
        outside_ = false;
    }
    /// Crosses the horizon between two pieces, whose common end rounding may put on both sides.
    void go_on(bool above, const Vec3& at) {
        if (!last_above_) {
            first_entry_ = at; // of a boundary that begins in the horizon
            return;
        }
        if (*last_above_ == above) return;
        if (above)
            enter(at);
        else
            leave(at);
    }
    /// Ends of a part of a rim and its places in the horizon between them, in the part's order.
    static std::size_t stops_of(const Rim& rim, double begin, double end,
                                std::array<double, 4>& stops) {
        std::size_t count = 0;
        stops[count++] = begin;
        if (rim.meets_horizon()) {
            const auto [low, high] = rim.above();
            const double turn = 2 * std::numbers::pi;
            for (const double place : {low - turn, low, high - turn, high, low + turn, high + turn})
                if (count < 3 && (place - begin) * (place - end) < 0) stops[count++] = place;
        }
        if (count == 3 && (stops[2] - stops[1]) * (end - begin) < 0) std::swap(stops[1], stops[2]);
        stops[count++] = end;
        return count;
    }

    Vec3 normal_;
    double sum_ = 0;
    std::optional<bool> last_above_; ///< the end of the last piece
    bool outside_ = false;           ///< went below the horizon at exit_ and is not back yet
    Vec3 exit_{0}, first_entry_{0};
};

} // namespace keiko
