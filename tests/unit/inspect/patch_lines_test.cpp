#include "keiko/inspect/basics/patch_lines.h"

#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

CPlane lamps_over() {
    CPlane lamps;
    lamps.origin = {-1800, -1800, 2500}, lamps.u = {3600, 500, 0}, lamps.v = {-500, 3600, 0};
    return lamps;
}

Camera camera_before() {
    Camera camera;
    camera.eye = {-2500, -600, 1500}, camera.target = {400, 0, 0};
    return camera;
}

std::vector<double> twelve_lamps() {
    const CPlaneFrame frame(lamps_over());
    std::vector<double> levels;
    for (int i = 0; i < 12; ++i) levels.push_back(frame.axis(i));
    return levels;
}

/// The coordinate across the lamps of the traced and reflected ray through a place of the surface.
std::optional<double> traced_value(const Tracer& tracer, const Vec3& eye, const Vec3& place) {
    Ray ray;
    ray.origin = eye, ray.direction = (place - eye).normalized();
    const std::optional<Hit> hit = tracer.nearest(ray);
    if (!hit || (hit->position - place).length() > 1e-3) return std::nullopt;
    const CPlaneFrame frame(lamps_over());
    const Ray mirrored = reflect_ray(ray, *hit);
    const Vec3 from = frame.point(mirrored.origin), slope = frame.vector(mirrored.direction);
    return from.y - slope.y * from.z / slope.z;
}

/// Bisects reflected rays of the tracer along a tangent through the point and across the line.
void expect_on_traced_line(const Tracer& tracer, const SurfaceModel& model, const LinePoint& point,
                           double level, int& compared) {
    const Vec3 eye = camera_before().eye;
    const SurfaceDerivatives s = evaluate(model.patch(0), point.uv, 1);
    const Vec3 tangents[] = {s.du().normalized(), s.dv().normalized()};
    double best_change = 0;
    Vec3 across(0);
    for (const Vec3& t : tangents) {
        const auto before = traced_value(tracer, eye, point.place - t * 1e-4);
        const auto after = traced_value(tracer, eye, point.place + t * 1e-4);
        if (!before || !after) return;
        if (std::abs(*after - *before) > std::abs(best_change))
            best_change = *after - *before, across = t;
    }
    double low = -1e-4, high = 1e-4;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        const auto value = traced_value(tracer, eye, point.place + across * middle);
        if (!value) return;
        ((*value < level) == (best_change > 0) ? low : high) = middle;
    }
    ++compared;
    EXPECT_LE(std::abs(low), 1e-6) << point.place;
}

TEST(PatchLines, AreWhereTracedAndMirroredRaysMeetTheLamps) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const Tracer tracer(model);
    const LineField field(LineLook::reflection, LineEye(camera_before()), lamps_over(), Vec3(0));
    const std::vector<double> levels = twelve_lamps();
    int compared = 0;
    const auto lines = patch_lines(model.patch(0), field, levels);
    ASSERT_FALSE(lines.empty());
    for (const PatchLine& line : lines) {
        EXPECT_TRUE(line.proved);
        EXPECT_LE(line.deviation, 0.01);
        for (std::size_t i = 0; i < line.points.size(); i += 7)
            expect_on_traced_line(tracer, model, line.points[i], levels[line.level], compared);
    }
    EXPECT_GT(compared, 100);
}

/// Both sides of a patch are alike: the normal is turned towards the viewpoint.
TEST(PatchLines, AreTheSameOnAPatchTurnedOver) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const BezierPatchView patch = model.patch(0);
    std::vector<Vec4> turned;
    for (int i = patch.degree_u; i >= 0; --i)
        for (int j = 0; j <= patch.degree_v; ++j) turned.push_back(patch.point(i, j));
    const BezierPatchView over{patch.degree_u, patch.degree_v, turned};
    for (const LineLook look : {LineLook::reflection, LineLook::highlight}) {
        const LineField field(look, LineEye(camera_before()), lamps_over(), Vec3(0));
        const auto visible = [&](const BezierPatchView& side) {
            double length = 0;
            for (const PatchLine& line : patch_lines(side, field, twelve_lamps()))
                for (std::size_t i = 1; i < line.points.size(); ++i) {
                    const Vec2 uv = (line.points[i].uv + line.points[i - 1].uv) / 2;
                    const SurfaceDerivatives s = evaluate(side, uv, 1);
                    if (field.image(s.position(), s.du().cross(s.dv())).faces)
                        length += (line.points[i].place - line.points[i - 1].place).length();
                }
            return length;
        };
        const double length = visible(patch);
        EXPECT_GT(length, 1000);
        EXPECT_NEAR(visible(over), length, 1e-3 * length) << name_of(look);
    }
}

TEST(PatchLines, EndOnTheBorderOfThePatchOrWhereNoRayMeetsTheLampsOrClose) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const BezierPatchView patch = model.patch(0);
    for (const LineLook look : {LineLook::reflection, LineLook::highlight}) {
        const LineField field(look, LineEye(camera_before()), lamps_over(), Vec3(0));
        const auto is_end = [&](const Vec2& uv) {
            const SurfaceDerivatives s = evaluate(patch, uv, 1);
            return uv.x == 0 || uv.x == 1 || uv.y == 0 || uv.y == 1 ||
                   !field.image(s.position(), s.du().cross(s.dv())).faces;
        };
        for (const PatchLine& line : patch_lines(patch, field, twelve_lamps())) {
            if (line.closed) continue;
            EXPECT_TRUE(is_end(line.points.front().uv)) << line.points.front().uv;
            EXPECT_TRUE(is_end(line.points.back().uv)) << line.points.back().uv;
        }
    }
}

} // namespace
} // namespace keiko
