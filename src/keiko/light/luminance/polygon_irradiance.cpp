#include "keiko/light/luminance/polygon_irradiance.h"

#include <cmath>

namespace keiko {
namespace {

/// The boundary sum of a polygon that is clipped to the horizon while its edges pass by, so that
/// nothing is stored. All vectors are relative to the point.
class ClippedBoundary {
public:
    explicit ClippedBoundary(const Vec3& normal) : normal_(normal) {}

    void add_edge(const Vec3& a, const Vec3& b) {
        const double ha = normal_.dot(a), hb = normal_.dot(b);
        const bool a_above = ha >= 0, b_above = hb >= 0;
        if (!a_above && !b_above) return;
        if (a_above && b_above) return add_arc(a, b);
        const Vec3 crossing = a + (b - a) * (ha / (ha - hb));
        if (a_above) {
            add_arc(a, crossing);
            exit_ = crossing;
            outside_ = true;
        } else {
            enter(crossing);
            add_arc(crossing, b);
        }
    }

    /// The sum over the closed boundary, signed by its orientation.
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

    /// The side that lies in the horizon counts in full: its great circle has the normal +-N.
    /// The signed angle about N stays right where the crossings nearly coincide.
    void add_horizon_arc(const Vec3& a, const Vec3& b) {
        sum_ += std::atan2(normal_.dot(a.cross(b)), a.dot(b));
    }

    void enter(const Vec3& crossing) {
        if (outside_) {
            add_horizon_arc(exit_, crossing);
        } else {
            first_entry_ = crossing; // its exit is the last one, met when the boundary closes
        }
        outside_ = false;
    }

    Vec3 normal_;
    double sum_ = 0;
    bool outside_ = false; ///< gone below the horizon at exit_, not yet back
    Vec3 exit_{0}, first_entry_{0};
};

} // namespace

double projected_solid_angle(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    if (corners.size() < 3) return 0;
    ClippedBoundary boundary(normal);
    Vec3 previous = corners.back() - point;
    for (const Vec3& corner : corners) {
        const Vec3 next = corner - point;
        boundary.add_edge(previous, next);
        previous = next;
    }
    return std::abs(boundary.closed());
}

} // namespace keiko
