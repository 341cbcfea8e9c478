#include "car_trims.h"

#include "car_body.h"
#include "car_greenhouse.h"
#include <math_Gauss.hxx>
#include <math_Matrix.hxx>
#include <math_Vector.hxx>

#include <cmath>
#include <limits>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr double kPi = std::numbers::pi;
/// Newton steps below this (in skin parameters, about 500 mm each) are rounding.
constexpr double kConverged = 1e-13;
constexpr int kNewtonSteps = 40;
/// Keeps the first steps from a crude start on the patch.
constexpr double kLongestStep = 0.3;

/// Solves `jacobian` x = `residual`.
math_Vector newton_step(const math_Matrix& jacobian, const math_Vector& residual) {
    math_Vector step(residual.Lower(), residual.Upper());
    math_Gauss(jacobian).Solve(residual, step);
    return step;
}

/// The circle about `wheel` in side view, tau being the angle from straight ahead over the top.
TrimPath wheel_arch_path(const Skin& body, WheelPlace wheel) {
    return [&body, wheel](double tau, const TrimPoint& near) {
        const double x = wheel.x - kArchRadius * std::cos(tau);
        const double z = wheel.z + kArchRadius * std::sin(tau);
        gp_XY uv = near.uv[0];
        for (int k = 0; k < kNewtonSteps; ++k) {
            const SkinPoint point = body.evaluate(uv);
            const double dx = point.position.X() - x;
            const double dz = point.position.Z() - z;
            const double det = point.du.X() * point.dv.Z() - point.dv.X() * point.du.Z();
            const gp_XY step((dx * point.dv.Z() - dz * point.dv.X()) / det,
                             (dz * point.du.X() - dx * point.du.Z()) / det);
            uv -= step;
            if (step.Modulus() < kConverged) break;
        }
        return TrimPoint{body.evaluate(uv).position, {uv}};
    };
}

/// A point of the right flank near (x, z) in side view.
gp_XY flank_point(const Skin& body, double x, double z) {
    constexpr double kInnermostFlank = 780.0;
    gp_XY best;
    double least = std::numeric_limits<double>::max();
    for (double u = 0.0; u <= 0.5 * body.columns(); u += 0.1)
        for (double v = 0.0; v <= body.rows(); v += 0.1) {
            const gp_XYZ p = body.evaluate({u, v}).position;
            const double distance = std::hypot(p.X() - x, p.Z() - z);
            if (p.Y() > kInnermostFlank && distance < least) {
                least = distance;
                best = {u, v};
            }
        }
    return best;
}

/// The angle at which the arch meets the sill (v = 0), between two angles on either side of it.
double sill_angle(const TrimPath& path, TrimPoint near, double above, double below) {
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (above + below);
        const TrimPoint point = path(middle, near);
        (point.uv[0].Y() > 0.0 ? above : below) = middle;
        if (point.uv[0].Y() > 0.0) near = point;
    }
    return above;
}

TrimCurve wheel_arch(const Skin& body, WheelPlace wheel) {
    const TrimPath path = wheel_arch_path(body, wheel);
    const gp_XY top = flank_point(body, wheel.x, wheel.z + kArchRadius);
    TrimPoint start{body.evaluate(top).position, {top}};
    TrimPoint front = start;
    for (double tau = 0.5 * kPi; tau > 0.0; tau -= 0.02) front = path(tau, front);
    TrimPoint rear = start;
    for (double tau = 0.5 * kPi; tau < kPi; tau += 0.02) rear = path(tau, rear);
    const double first = sill_angle(path, front, 0.0, -0.6);
    const double last = sill_angle(path, rear, kPi, kPi + 0.6);
    return trace(path, first, last, front, {&body});
}

/// Body and greenhouse meet in the half plane through the vertical axis x = kMiddle that tau
/// turns from the tail (0) over the right to the nose (pi).
TrimPath foot_path(const Skin& body, const Skin& greenhouse) {
    constexpr double kMiddle = 2500.0;
    constexpr double kSlenderness = 0.45;
    return [&](double tau, const TrimPoint& near) {
        TrimPoint point = near;
        const gp_XYZ across(std::sin(tau) * kSlenderness, -std::cos(tau), 0.0);
        for (int k = 0; k < kNewtonSteps; ++k) {
            const SkinPoint b = body.evaluate(point.uv[0]);
            const SkinPoint g = greenhouse.evaluate(point.uv[1]);
            math_Matrix jacobian(1, 4, 1, 4, 0.0);
            math_Vector residual(1, 4);
            const gp_XYZ gap = b.position - g.position;
            for (int axis = 1; axis <= 3; ++axis) {
                residual(axis) = gap.Coord(axis);
                jacobian(axis, 1) = b.du.Coord(axis);
                jacobian(axis, 2) = b.dv.Coord(axis);
                jacobian(axis, 3) = -g.du.Coord(axis);
                jacobian(axis, 4) = -g.dv.Coord(axis);
            }
            residual(4) = (b.position - gp_XYZ(kMiddle, 0.0, 0.0)).Dot(across);
            jacobian(4, 1) = b.du.Dot(across);
            jacobian(4, 2) = b.dv.Dot(across);
            math_Vector step = newton_step(jacobian, residual);
            step.Multiply(std::min(1.0, kLongestStep / step.Norm()));
            point.uv[0] -= gp_XY(step(1), step(2));
            point.uv[1] -= gp_XY(step(3), step(4));
            if (step.Norm() < kConverged) break;
        }
        point.position = body.evaluate(point.uv[0]).position;
        return point;
    };
}

/// The places in the plane of symmetry, at the tail, where body and greenhouse come closest.
TrimPoint foot_start(const Skin& body, const Skin& greenhouse) {
    TrimPoint best{{}, {{}, {}}};
    double least = std::numeric_limits<double>::max();
    const double tail = 0.5 * body.columns();
    for (double v = 0.8 * body.rows(); v <= body.rows(); v += 0.02)
        for (double u = 0.5 * greenhouse.columns(); u <= greenhouse.columns(); u += 0.05) {
            const gp_XY on_greenhouse(u, 0.5 * greenhouse.rows());
            const gp_XYZ position = body.evaluate({tail, v}).position;
            const double gap = (position - greenhouse.evaluate(on_greenhouse).position).Modulus();
            if (gap < least) {
                least = gap;
                best = {position, {{tail, v}, on_greenhouse}};
            }
        }
    return best;
}

TrimCurve greenhouse_foot(const Skin& body, const Skin& greenhouse) {
    const std::vector<const Skin*> skins{&body, &greenhouse};
    const TrimCurve right =
        trace(foot_path(body, greenhouse), 0.0, kPi, foot_start(body, greenhouse), skins);
    return with_mirror_image(right, {mirrored_on_body, mirrored_on_greenhouse}, skins);
}

} // namespace

CarTrims car_trims(const Skin& body, const Skin& greenhouse) {
    CarTrims trims;
    trims.greenhouse_foot = greenhouse_foot(body, greenhouse);
    for (std::size_t k = 0; k < kWheels.size(); ++k) {
        trims.wheel_arches[k] = wheel_arch(body, kWheels[k]);
        trims.wheel_arches[k + 2] = mirrored(trims.wheel_arches[k], {mirrored_on_body}, {&body});
    }
    trims.body_panels = car_body_panels(body);
    trims.windows = car_windows(greenhouse);
    return trims;
}

bool is_in_wheel_arch(const Skin& body, Cell cell) {
    const gp_XYZ middle = body.evaluate({cell.column + 0.5, cell.row + 0.5}).position;
    for (const WheelPlace& wheel : kWheels)
        if (std::hypot(middle.X() - wheel.x, middle.Z() - wheel.z) < kArchRadius &&
            std::abs(middle.Y()) > 500.0)
            return true;
    return false;
}

} // namespace keiko::fixtures
