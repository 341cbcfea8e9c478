#include "keiko/light/tubes/c_plane.h"
#include "keiko/render/shading/direct_lighting.h"
#include "keiko/visibility/query/visibility_query.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using namespace test;

/// Turns by an angle about a direction.
class Turn {
public:
    Turn(const Vec3& about, double angle) : axis_(about.normalized()), angle_(angle) {}
    Vec3 operator()(const Vec3& v) const {
        return v * std::cos(angle_) + axis_.cross(v) * std::sin(angle_) +
               axis_ * (axis_.dot(v) * (1 - std::cos(angle_)));
    }

private:
    Vec3 axis_;
    double angle_;
};

constexpr double radius = 50, height = 1000, half_length = 600;

/// A point in the origin under a tube along x, past rectangles, all of it turned.
struct TurnedScene {
    Turn turn;
    ModelBuilder builder{};

    void plate(const Vec3& origin, const Vec3& u, const Vec3& v) {
        builder.plane(turn(origin), turn(u), turn(v));
    }
    LightRig rig() const {
        CPlane plane{.origin = turn({-half_length, -200, height}),
                     .u = turn({2 * half_length, 0, 0}),
                     .v = turn({0, 400, 0}),
                     .lamps = 1,
                     .diameter = 2 * radius};
        LightRig rig;
        rig.sources = {plane};
        return rig;
    }
    LightVisibility seen(const Vec3& point, const SurfaceModel& model) const {
        const Tracer tracer(model);
        const Occluders occluders(model, tracer);
        const LightRig lit = rig();
        const PreparedRig prepared(lit);
        const DirectLighting shadowed(prepared, &occluders, tracer);
        return shadowed.light_visibility(turn(point), turn({0, 0, 1}), {}, shadowed.lights(),
                                         TubeModel::automatic)[0];
    }
};

/// Share of the light of the near side, in strips, that reaches a point past `hidden`(way).
template <class Hidden>
double share_by_strips(const Vec3& point, const Hidden& hidden) {
    constexpr int around = 1000, along = 200;
    constexpr double pi = std::numbers::pi;
    const Vec3 up = Vec3(0, -point.y, height - point.z).normalized();
    const Vec3 sideways = Vec3(1, 0, 0).cross(up);
    double all = 0, seen = 0;
    for (int i = 0; i < around; ++i) {
        const double phi = pi * ((i + 0.5) / around - 0.5);
        const Vec3 out = sideways * std::sin(phi) - up * std::cos(phi);
        for (int k = 0; k < along; ++k) {
            const double x = half_length * (2 * (k + 0.5) / along - 1);
            const Vec3 way = Vec3(x, 0, height) + out * radius - point;
            const double squared = way.length2();
            const double light =
                std::max(0.0, way.z) * std::max(0.0, -out.dot(way)) / (squared * squared);
            all += light;
            if (!hidden(way)) seen += light;
        }
    }
    return seen / all;
}

const Turn turns[] = {{{0, 0, 1}, 0},
                      {{0, 0, 1}, 0.5},
                      {{0, 0, 1}, std::numbers::pi / 4},
                      {{1, 2, 3}, 1.1},
                      {{-2, 1, 0.4}, 2.3}};

/// Also of an outline that crosses nothing but the rim of the tube.
TEST(TurnedLamps, LoseWhatAnEdgeAlongThemHides) {
    for (const Turn& turn : turns)
        for (const double beyond : {-24.5, -20.0, -3.0, 11.0, 23.0, 24.7}) {
            TurnedScene scene{turn};
            scene.plate({-2000, beyond, height / 2}, {4000, 0, 0}, {0, 300, 0});
            const double exact = share_by_strips(
                Vec3(0), [&](const Vec3& way) { return way.y * (height / 2) > beyond * way.z; });
            EXPECT_NEAR(scene.seen(Vec3(0), scene.builder.build()).share, exact, 1.5e-3) << beyond;
        }
}

/// Bars narrower than a tenth of the width may fall between the lines that are computed.
TEST(TurnedLamps, LoseWhatABarAlongThemHides) {
    for (const Turn& turn : turns)
        for (const double width : {5.0, 15.0})
            for (const double begin : {-23.0, -14.0, -9.0, -4.0, 1.0, 6.0, 12.0}) {
                TurnedScene scene{turn};
                scene.plate({-2000, begin, height / 2}, {4000, 0, 0}, {0, width, 0});
                const double exact = share_by_strips(Vec3(0), [&](const Vec3& way) {
                    const double y = way.y / way.z * (height / 2);
                    return y > begin && y < begin + width;
                });
                EXPECT_NEAR(scene.seen(Vec3(0), scene.builder.build()).share, exact, 1.5e-3)
                    << begin << ' ' << width;
            }
}

/// A plate that stands before the end of a tube hides the axis there, but not the tube's near side.
TEST(TurnedLamps, AreHiddenByTheirSockets) {
    for (const Turn& turn : turns)
        for (const Vec3& point : {Vec3(-2500, 30, 0), Vec3(-900, 0, 300), Vec3(100, -40, 0)}) {
            TurnedScene scene{turn};
            scene.plate({-half_length - 1, -radius, height - radius}, {0, 2 * radius, 0},
                        {0, 0, 2 * radius});
            const SurfaceModel model = scene.builder.build();
            const Tracer tracer(model);
            const Occluders occluders(model, tracer);
            const LightRig rig = scene.rig();
            const auto& plane = std::get<CPlane>(rig.sources[0]);
            const CPlaneFrame frame(plane);
            const Vec3 corners[] = {frame.at(0, 200), frame.at(frame.length, 200)};
            const VisibilityQuery view(occluders, tracer, Viewpoint::at(turn(point)), corners,
                                       turn({0, 0, 1}));
            const IntervalSet axis = view.intervals({corners[0], corners[1]}).intervals;
            const IntervalSet told = scene.seen(point, model).axis;
            ASSERT_EQ(told.size(), axis.size()) << point.x;
            for (std::size_t i = 0; i < axis.size(); ++i) {
                EXPECT_NEAR(told[i].begin, axis[i].begin, 1e-9);
                EXPECT_NEAR(told[i].end, axis[i].end, 1e-9);
            }
        }
}

} // namespace
} // namespace keiko
