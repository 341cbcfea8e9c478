#include "keiko/inspect/lines/line_geometry.h"

#include "keiko/inspect/basics/patch_lines.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

LineField field_over(LineLook look) {
    CPlane lamps;
    lamps.origin = {-1800, -1800, 2500}, lamps.u = {3600, 500, 0}, lamps.v = {-500, 3600, 0};
    Camera camera;
    camera.eye = {-2500, -600, 1500};
    return {look, LineEye(camera), lamps, Vec3(0)};
}

/// The point of the line `step` mm further on, found by a change of sign across it.
Vec3 followed(const BezierPatchView& patch, const LineField& field, double level, const Vec2& uv,
              const Vec3& tangent, double step) {
    const LevelFunction f(patch, field, level);
    const SurfaceDerivatives s = evaluate(patch, uv, 1);
    // Solves tangent = a du + b dv in the tangent plane.
    const double E = s.du().length2(), F = s.du().dot(s.dv()), G = s.dv().length2();
    const double p = tangent.dot(s.du()), q = tangent.dot(s.dv());
    const Vec2 along = Vec2(G * p - F * q, E * q - F * p) / (E * G - F * F);
    const Vec2 ahead = uv + along * step, across = Vec2(-along.y, along.x) * std::abs(step);
    const Vec2 low = ahead - across, high = ahead + across;
    return evaluate(patch, f.root(low, f(low), high, f(high)), 0).position();
}

TEST(LineGeometry, IsThatOfTheLineFollowedStepByStep) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const BezierPatchView patch = model.patch(0);
    for (const LineLook look : {LineLook::reflection, LineLook::highlight, LineLook::isophote})
        for (const Vec2& uv : {Vec2(0.3, 0.4), Vec2(0.7, 0.2), Vec2(0.55, 0.8)}) {
            const LineField field = field_over(look);
            const SurfaceDerivatives s = evaluate(patch, uv, 3);
            const double level = field.image(s.position(), s.du().cross(s.dv())).value;
            const auto course = line_course(field, level, s);
            ASSERT_TRUE(course) << name_of(look);
            EXPECT_NEAR(course->value, 0, 1e-9);
            const double h = 2;
            const auto at = [&](double step) {
                return followed(patch, field, level, uv, course->tangent, step) - s.position();
            };
            const Vec3 first = (at(h) * 8 - at(-h) * 8 - at(2 * h) + at(-2 * h)) / (12 * h);
            const Vec3 second = (at(h) * 16 + at(-h) * 16 - at(2 * h) - at(-2 * h)) / (12 * h * h);
            EXPECT_NEAR(angle_between(first, course->tangent), 0, 1e-8) << name_of(look);
            const double bend =
                course->normal.dot(first.cross(second)) / std::pow(first.length(), 3);
            EXPECT_NEAR(bend, course->bend, 1e-7 * std::max(1e-3, std::abs(bend)) * 1e3)
                << name_of(look);
        }
}

TEST(LineGeometry, RisesToTheLeftByItsDensity) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const BezierPatchView patch = model.patch(0);
    for (const LineLook look : {LineLook::reflection, LineLook::highlight, LineLook::isophote}) {
        const LineField field = field_over(look);
        const Vec2 uv(0.3, 0.4);
        const auto value = [&](const Vec2& at) {
            const SurfaceDerivatives s = evaluate(patch, at, 1);
            return field.image(s.position(), s.du().cross(s.dv())).value;
        };
        const SurfaceDerivatives s = evaluate(patch, uv, 3);
        const auto course = line_course(field, value(uv), s);
        ASSERT_TRUE(course);
        const double h = 1e-5;
        EXPECT_NEAR((value({uv.x + h, uv.y}) - value({uv.x - h, uv.y})) / (2 * h),
                    course->gradient().dot(s.du()), 1e-5 * std::abs(course->density * 1200));
        EXPECT_NEAR((value({uv.x, uv.y + h}) - value({uv.x, uv.y - h})) / (2 * h),
                    course->gradient().dot(s.dv()), 1e-5 * std::abs(course->density * 1400));
    }
}

/// The spacing pitch / density is asked at both sides of the place.
TEST(LineGeometry, TellsHowTheSpacingGrows) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const BezierPatchView patch = model.patch(0);
    const LineField field = field_over(LineLook::reflection);
    const auto course_at = [&](const Vec2& at) {
        const SurfaceDerivatives s = evaluate(patch, at, 3);
        return *line_course(field, field.image(s.position(), s.du().cross(s.dv())).value, s);
    };
    const Vec2 uv(0.3, 0.4);
    const SurfaceDerivatives s = evaluate(patch, uv, 1);
    const LineGeometry course = course_at(uv);
    const Vec3 growth = course.tangent * course.spread_along + course.left() * course.spread_across;
    const double h = 1e-4;
    const auto log_spacing = [&](const Vec2& at) { return -std::log(course_at(at).density); };
    EXPECT_NEAR((log_spacing({uv.x + h, uv.y}) - log_spacing({uv.x - h, uv.y})) / (2 * h),
                growth.dot(s.du()), 1e-6);
    EXPECT_NEAR((log_spacing({uv.x, uv.y + h}) - log_spacing({uv.x, uv.y - h})) / (2 * h),
                growth.dot(s.dv()), 1e-6);
}

TEST(LineGeometry, BoundsHoldWhatAPlaceNearbyHas) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const BezierPatchView patch = model.patch(0);
    const LineField field = field_over(LineLook::reflection);
    const Vec2 uv(0.3, 0.4);
    const SurfaceDerivatives s = evaluate(patch, uv, 3);
    const LineGeometry course = *line_course(field, 1000, s);
    const double off = 1e-3; // mm
    const LineGeometryBounds bounds = line_course_bounds(field, 1000, s, 3, off);
    for (const Vec2& step : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
        const Vec2 beside = uv + Vec2(step.x / s.du().length(), step.y / s.dv().length()) * off;
        const LineGeometry other = *line_course(field, 1000, evaluate(patch, beside, 3));
        EXPECT_LE(angle_between(other.tangent, course.tangent), bounds.direction);
        EXPECT_LE(std::abs(other.bend - course.bend), bounds.bend);
        EXPECT_LE(std::abs(other.value - course.value), bounds.value);
    }
    const LineGeometryBounds sharp = line_course_bounds(field, 1000, s, 3, 0);
    EXPECT_LT(sharp.direction, 1e-10);
    EXPECT_LT(sharp.bend, 1e-12);
    EXPECT_LT(sharp.value, 1e-8);
}

} // namespace
} // namespace keiko
