#include "car_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr int kHalfColumns = 11;
constexpr int kRows = 5;
constexpr int kDegree = 5;
/// A quintic uniform spline needs two control points beyond each end of its spans.
constexpr int kBeyond = 2;
constexpr int kControls = kRows + kDegree;

/// Outline of the body seen from above, right half, by its heading: 0 across the nose, 90 degrees
/// along the flank, 180 across the tail. Lengths in mm of arc.
constexpr double kArcLength = 5900.0;

struct PlanPoint {
    double x;
    double y;
    double heading;
};

double sigmoid(double x) {
    return 0.5 * (1.0 + std::tanh(x));
}

/// A turn of one radian spread smoothly about `place`, odd about the ends of the outline, so that
/// the mirrored halves join without a break in any derivative.
double turn(double arc, double place, double width) {
    return sigmoid((arc - place) / width) - sigmoid((-arc - place) / width);
}

double heading(double arc) {
    constexpr double kCorner = 0.475;
    constexpr double kFlank = 1.0 - 2.0 * kCorner;
    const double front = turn(arc, 760.0, 240.0);
    const double rear = 1.0 - turn(kArcLength - arc, 740.0, 240.0);
    return std::numbers::pi * (kCorner * (front + rear) + kFlank * arc / kArcLength);
}

PlanPoint plan_point(double arc) {
    constexpr int kSteps = 2000;
    const double step = arc / kSteps;
    PlanPoint point{0.0, 0.0, heading(arc)};
    for (int k = 0; k < kSteps; ++k) {
        const double angle = heading((k + 0.5) * step);
        point.x += std::sin(angle) * step;
        point.y += std::cos(angle) * step;
    }
    return point;
}

/// One control point of a profile: share of the way to the inner ring, and height in mm.
struct ProfilePoint {
    double inset;
    double height;
};
using Profile = std::array<ProfilePoint, kControls>;

/// Profiles from below the sill to under the greenhouse, in the middle of nose, flank and tail.
constexpr Profile kNose{{{0.20, 40},
                         {0.085, 118},
                         {0.02, 222},
                         {0.0, 345},
                         {0.02, 480},
                         {0.15, 610},
                         {0.56, 745},
                         {1.36, 858},
                         {2.22, 935},
                         {3.05, 990}}};
constexpr Profile kFlank{{{0.50, 20},
                          {0.20, 110},
                          {0.05, 230},
                          {0.0, 375},
                          {0.01, 522},
                          {0.08, 665},
                          {0.36, 775},
                          {1.20, 835},
                          {2.15, 855},
                          {3.1, 862}}};
constexpr Profile kTail{{{0.20, 105},
                         {0.10, 180},
                         {0.035, 285},
                         {0.0, 415},
                         {0.0, 560},
                         {0.015, 705},
                         {0.09, 848},
                         {0.42, 918},
                         {0.90, 924},
                         {1.40, 920}}};

ProfilePoint blended(std::size_t row, double angle) {
    const double nose = std::pow(std::max(0.0, std::cos(angle)), 3.0);
    const double tail = std::pow(std::max(0.0, -std::cos(angle)), 3.0);
    const double flank = 1.0 - nose - tail;
    const auto mix = [&](auto member) {
        return nose * kNose[row].*member + flank * kFlank[row].*member + tail * kTail[row].*member;
    };
    return {mix(&ProfilePoint::inset), mix(&ProfilePoint::height)};
}

/// Length and half width of the net's outline; the spline stays 60 and 15 mm inside.
constexpr double kLength = 4660.0;
constexpr double kHalfWidth = 940.0;

/// Between outline and inner ring, its image shrunk towards the middle, at the profile's inset.
gp_XYZ control_point(int column, int row) {
    constexpr double kMiddle = 0.5 * kLength;
    constexpr double kRingLength = 0.54;
    constexpr double kRingWidth = 0.71;
    // The shoulder rises towards the tail, the sill does not.
    constexpr double kWedge = 0.022;
    const double share = static_cast<double>(column) / kHalfColumns;
    const PlanPoint tail = plan_point(kArcLength);
    const PlanPoint plan = plan_point(kArcLength * share);
    const double x = plan.x * kLength / tail.x;
    // The tail's end need not come out at y = 0 by itself: shear it there.
    const double y = (plan.y - tail.y * share) * kHalfWidth / plan_point(0.5 * kArcLength).y;
    const ProfilePoint profile = blended(static_cast<std::size_t>(row), plan.heading);
    const double rise = kWedge * (x - kMiddle) * std::clamp((row - 2) / 3.5, 0.0, 1.0);
    return {x + profile.inset * (1.0 - kRingLength) * (kMiddle - x),
            y * (1.0 - profile.inset * (1.0 - kRingWidth)), profile.height + rise};
}

} // namespace

gp_XY mirrored_on_body(gp_XY uv) {
    return {2.0 * kHalfColumns - uv.X(), uv.Y()};
}

Skin car_body() {
    constexpr int kColumns = 2 * kHalfColumns;
    const UniformSpline right{
        kDegree, kDegree, sample_net(kHalfColumns + kDegree, kControls, [](int i, int j) {
            const int column = i - kBeyond;
            // Beyond nose and tail the right half goes on as the mirror image of itself.
            const int turned = column > kHalfColumns ? kColumns - column : std::abs(column);
            const gp_XYZ point = control_point(turned, j);
            return gp_XYZ(point.X(), turned == column ? point.Y() : -point.Y(), point.Z());
        })};
    return Skin(kColumns, kRows, true, [&](Cell cell) {
        const bool left = cell.column >= kHalfColumns;
        const int column = left ? kColumns - 1 - cell.column : cell.column;
        const Net net = bezier_net(right, column, cell.row);
        return sample_net(kDegree + 1, kDegree + 1, [&](int a, int b) {
            const int i = left ? kDegree - a : a;
            const gp_XYZ point = net(i, b);
            const int place = column * kDegree + i;
            // Zero, were it not for rounding, which must not open a gap in the middle.
            const bool middle = place == 0 || place == kHalfColumns * kDegree;
            return gp_XYZ(point.X(), middle ? 0.0 : (left ? -point.Y() : point.Y()), point.Z());
        });
    });
}

} // namespace keiko::fixtures
