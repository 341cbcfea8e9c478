#include "keiko/placement/place_lamps.h"

#include "keiko/base/error.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/placement/candidate_planes.h"
#include "keiko/placement/view_samples.h"
#include "keiko/scene/view.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace keiko {
namespace {

constexpr Framing small_picture{.width = 128, .height = 72};

/// Few samples, for tests that place much.
PlacementOptions quick() {
    PlacementOptions options;
    options.sampling.samples = 2000;
    return options;
}

Affine cylinder_along_y(double radius, double length) {
    return test::stretched({radius, radius, length / 2}, {0, 1, 0}, {0, 0, radius});
}

/// A model, its tracer and the camera of a named view.
struct Scene {
    explicit Scene(SurfaceModel body, std::string_view view = "three-quarter-front",
                   const Framing& framing = small_picture)
        : model(std::move(body)),
          tracer(model),
          camera(frame_view(view, material_bounds(model), framing)) {}

    Placement place(const PlacementOptions& options = {}, const Job& job = {}) const {
        return place_lamps(tracer, model, camera, options, job);
    }

    SurfaceModel model;
    Tracer tracer;
    Camera camera;
};

const CPlane& plane(const Placement& placement, std::size_t i = 0) {
    return std::get<CPlane>(placement.rig.sources.at(i));
}

/// Lamps that the pixels of a picture mirror, found anew from the rig alone.
struct Mirrored {
    int seen = 0;                                ///< pixels that see the body
    int covered = 0;                             ///< of these, mirror some lamp rectangle
    int lit = 0;                                 ///< mirror a lamp itself
    std::set<std::pair<std::size_t, int>> lamps; ///< planes and lamps that appear
};
Mirrored look(const Scene& scene, const LightRig& rig) {
    Mirrored result;
    for (int y = 0; y < scene.camera.height; ++y)
        for (int x = 0; x < scene.camera.width; ++x) {
            const Ray eye = scene.camera.ray(x + 0.5, y + 0.5);
            const auto hit = scene.tracer.nearest(eye);
            if (!hit) continue;
            ++result.seen;
            const Vec3 n = hit->normal, r = reflect(eye.direction, n);
            Ray mirror;
            mirror.origin = hit->position;
            mirror.direction = r;
            mirror.excluded = hit->root;
            if (scene.tracer.any(mirror)) continue;
            bool covered = false, lit = false;
            for (std::size_t i = 0; i < rig.sources.size(); ++i) {
                const auto& p = std::get<CPlane>(rig.sources[i]);
                const Vec3 normal = p.u.cross(p.v).normalized();
                const double t = normal.dot(p.origin - hit->position) / normal.dot(r);
                if (!(t > 0)) continue;
                const Vec3 place = hit->position + r * t - p.origin;
                const double u = place.dot(p.u) / p.u.length2();
                const double v = place.dot(p.v) / p.v.length2();
                if (u < 0 || u > 1 || v < 0 || v > 1) continue;
                covered = true;
                const int lamp = static_cast<int>(v * p.lamps);
                const double beside = (v * p.lamps - lamp - 0.5) * p.spacing();
                if (std::abs(beside) > p.diameter / 2) continue;
                lit = true;
                result.lamps.insert({i, lamp});
            }
            result.covered += covered ? 1 : 0;
            result.lit += lit ? 1 : 0;
        }
    return result;
}

TEST(PlaceLamps, StripesCoverABonnetWithOnePlane) {
    for (const std::string_view view :
         {"three-quarter-front", "high-front", "standing-right", "top", "high-rear"}) {
        const Scene scene(test::bonnet_model(1100, 1400, 60), view);
        const Placement placed = scene.place();
        EXPECT_EQ(placed.rig.sources.size(), 1u) << view;
        EXPECT_GT(placed.coverage, 0.85) << view;
        EXPECT_EQ(plane(placed).lamps, 12);

        const Mirrored seen = look(scene, placed.rig);
        EXPECT_NEAR(static_cast<double>(seen.covered) / seen.seen, placed.coverage, 0.02) << view;
        EXPECT_GE(seen.lamps.size(), 11u) << view;
        const double duty = plane(placed).diameter / plane(placed).spacing();
        EXPECT_NEAR(static_cast<double>(seen.lit) / seen.covered, duty, 0.25 * duty) << view;
    }
}

TEST(PlaceLamps, SeveralPlanesServeWhatOneCannot) {
    for (const bool sphere : {false, true}) {
        const Scene scene(sphere ? test::sphere_model(Affine::scale(500))
                                 : test::cylinder_model(cylinder_along_y(400, 3000)),
                          "front");
        PlacementOptions one;
        one.planes = 1;
        const Placement single = scene.place(one), several = scene.place();
        EXPECT_GT(single.coverage, 0.3);
        EXPECT_GT(several.coverage, single.coverage + 0.15);
        EXPECT_GT(several.coverage, sphere ? 0.7 : 0.85);
        EXPECT_EQ(several.planes.size(), several.rig.sources.size());
        const Mirrored seen = look(scene, several.rig);
        EXPECT_NEAR(static_cast<double>(seen.covered) / seen.seen, several.coverage, 0.02);
    }
}

TEST(PlaceLamps, ScalingTheBodyScalesTheLampsAndLeavesTheScores) {
    const auto placed = [](double scale) {
        SurfaceModel model = test::bonnet_model(1000, 1300, 70);
        model.instances[0].transform = Affine::scale(scale);
        return Scene(std::move(model)).place();
    };
    const Placement car = placed(1);
    for (const double scale : {5e-3, 40.0}) {
        const Placement other = placed(scale);
        EXPECT_NEAR(plane(other).pitch / plane(car).pitch, scale, 1e-6 * scale);
        EXPECT_LT((plane(other).origin - plane(car).origin * scale).length(), 1e-3 * scale);
        EXPECT_NEAR(other.coverage, car.coverage, 1e-9);
        EXPECT_NEAR(other.planes[0].score.objective(), car.planes[0].score.objective(), 1e-6);
        const double duty = plane(other).diameter / plane(other).pitch;
        EXPECT_GE(duty, 0.3 - 1e-12);
        EXPECT_LE(duty, 0.5 + 1e-12);
    }
}

TEST(PlaceLamps, DiameterIsThatOfATubeWhereThePitchAllows) {
    EXPECT_EQ(lamp_diameter(70), 26);
    EXPECT_DOUBLE_EQ(lamp_diameter(10), 5);
    EXPECT_DOUBLE_EQ(lamp_diameter(1000), 300);
}

TEST(PlaceLamps, ThreadsDoNotChangeTheRig) {
    const Scene scene(
        test::sphere_model(test::stretched({900, 600, 400}, {0, 0, 1}, {10, 20, 30})));
    const auto placed = [&](int threads) {
        Job job;
        job.threads = threads;
        return scene.place(quick(), job);
    };
    const Placement one = placed(1), two = placed(2);
    ASSERT_EQ(one.rig.sources.size(), two.rig.sources.size());
    for (std::size_t i = 0; i < one.rig.sources.size(); ++i) {
        EXPECT_EQ(plane(one, i).origin, plane(two, i).origin);
        EXPECT_EQ(plane(one, i).u, plane(two, i).u);
        EXPECT_EQ(plane(one, i).v, plane(two, i).v);
        EXPECT_EQ(plane(one, i).pitch, plane(two, i).pitch);
    }
    EXPECT_EQ(one.coverage, two.coverage);
}

TEST(PlaceLamps, LampsKeepClearOfTheBodyOfEachOtherAndOfTheEye) {
    for (const std::string_view view : {"three-quarter-rear", "high-front"}) {
        const Scene scene(
            test::sphere_model(test::stretched({2300, 900, 700}, {0, 0, 1}, {0, 0, 700})), view);
        const Placement placed = scene.place(quick());
        for (std::size_t i = 0; i < placed.rig.sources.size(); ++i) {
            EXPECT_FALSE(overlap(oriented(plane(placed, i)), oriented(scene.tracer.bounds())));
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(overlap(oriented(plane(placed, i)), oriented(plane(placed, j))));
            // The middle of the view is not viewed through the lamps.
            const CPlane& p = plane(placed, i);
            const Vec3 n = p.u.cross(p.v), view_ray = scene.camera.target - scene.camera.eye;
            const double t = n.dot(p.origin - scene.camera.eye) / n.dot(view_ray);
            const Vec3 place = scene.camera.eye + view_ray * t - p.origin;
            const double u = place.dot(p.u) / p.u.length2(), v = place.dot(p.v) / p.v.length2();
            EXPECT_FALSE(t > 0 && t < 1 && u > 0 && u < 1 && v > 0 && v < 1) << view;
        }
    }
}

TEST(PlaceLamps, LampsRunAsAsked) {
    const Scene scene(test::bonnet_model(1100, 1400, 60), "high-front");
    PlacementOptions options;
    options.direction = LampDirection::along;
    const CPlane along = plane(scene.place(options));
    // In the plane that the vehicle's x axis and the C-plane's normal span.
    const Vec3 normal = along.u.cross(along.v).normalized();
    EXPECT_NEAR(along.u.normalized().dot(normal.cross(Vec3(1, 0, 0)).normalized()), 0, 1e-12);
    options.direction = LampDirection::across;
    EXPECT_NEAR(plane(scene.place(options)).u.normalized().x, 0, 1e-12);
}

TEST(PlaceLamps, TheNumberOfLampsIsAsAskedOrGivesTheWantedSpacing) {
    const Scene scene(test::bonnet_model(1100, 1400, 60), "high-front",
                      {.width = 960, .height = 540});
    PlacementOptions options;
    options.lamps = 20;
    EXPECT_EQ(plane(scene.place(options)).lamps, 20);
    options.lamps = 0;
    const Placement placed = scene.place(options);
    const PlaneFrame frame = frame_of(plane(placed));
    std::vector<double> spacings; // px between neighbouring stripes
    for (const ViewSample& s :
         sample_views(scene.tracer, scene.model, std::span(&scene.camera, 1), {}))
        if (const auto hit = meet(frame, s.mirror))
            spacings.push_back(plane(placed).pitch / hit->gradients.value().v.length());
    std::nth_element(spacings.begin(), spacings.begin() + static_cast<long>(spacings.size() / 2),
                     spacings.end());
    EXPECT_NEAR(spacings[spacings.size() / 2], 24, 3);
}

TEST(PlaceLamps, NamesTheFacesThatLampsDoNotReach) {
    test::ModelBuilder builder; // the floor mirrors the wall behind it more than anything else
    const std::uint32_t floor = builder.plane({0, -500, 0}, {1000, 0, 0}, {0, 1000, 0});
    const std::uint32_t wall = builder.plane({1000, -500, 0}, {0, 1000, 0}, {0, 0, 1000});
    Scene scene(builder.build(), "front");
    scene.camera.eye = {-2500, 0, 800};
    scene.camera.target = {500, 0, 400};
    const Placement placed = scene.place();
    double blocked_floor = 0, floor_weight = 0;
    for (const ViewSample& s :
         sample_views(scene.tracer, scene.model, std::span(&scene.camera, 1), {})) {
        if (s.face != floor) continue;
        floor_weight += s.weight;
        blocked_floor += s.blocked ? s.weight : 0;
    }
    ASSERT_EQ(placed.faces.size(), 2u);
    EXPECT_EQ(placed.faces[0].face, floor); // the largest unreached part first
    EXPECT_LE(placed.faces[0].reached, 1 - blocked_floor / floor_weight + 1e-9);
    EXPECT_LT(placed.faces[0].reached, 0.3);
    EXPECT_EQ(placed.faces[1].face, wall);
    EXPECT_GT(placed.faces[1].reached, 0.5);
    double covered = 0;
    for (const FaceCoverage& f : placed.faces) covered += f.share * f.reached;
    EXPECT_NEAR(covered, placed.coverage, 1e-12);
    EXPECT_LE(placed.coverage, 1 - placed.blocked + 1e-9);
    EXPECT_GT(placed.blocked, 0.2);
    ASSERT_FALSE(placed.diagnostics.empty());
    EXPECT_EQ(placed.diagnostics[0].entity, "face 1");
    EXPECT_EQ(placed.diagnostics[0].severity, Severity::warning);
}

TEST(PlaceLamps, ServesTheChosenFacesAlone) {
    test::ModelBuilder builder;
    builder.plane({0, -500, 1000}, {1500, 0, 0}, {0, 1000, 0});
    const std::uint32_t door = builder.plane({0, -600, 200}, {600, 0, 0}, {0, 0, 600});
    const Scene scene(builder.build(), "high-three-quarter-front");
    EXPECT_GT(scene.place().coverage, 0.9);
    PlacementOptions options;
    options.sampling.faces = {door};
    const Placement for_door = scene.place(options);
    ASSERT_EQ(for_door.faces.size(), 1u);
    EXPECT_EQ(for_door.faces[0].share, 1);
    EXPECT_GT(for_door.coverage, 0.9);
    EXPECT_LT(plane(for_door).u.length(), plane(scene.place()).u.length());
}

TEST(PlaceLamps, OneRigCanServeSeveralViews) {
    const Scene scene(test::bonnet_model(1100, 1400, 60));
    const std::vector<Camera> views{
        frame_view("high-front", material_bounds(scene.model), small_picture),
        frame_view("high-rear", material_bounds(scene.model), small_picture)};
    // What one view mirrors hangs behind the other's eye, or would hide the body from it.
    const Placement placed = place_lamps(scene.tracer, scene.model, views);
    EXPECT_GT(placed.coverage, 0.7);
    for (const Camera& view : views) {
        Scene one = Scene(scene.model);
        one.camera = view;
        const Mirrored seen = look(one, placed.rig);
        EXPECT_GT(static_cast<double>(seen.covered) / seen.seen, 0.6);
    }
}

TEST(PlaceLamps, ItsNumbersAreReported) {
    const Scene scene(test::bonnet_model(1100, 1400, 60));
    const Placement placed = scene.place();
    ASSERT_EQ(placed.planes.size(), 1u);
    const PlacedPlane& first = placed.planes[0];
    EXPECT_NEAR(first.score.coverage, placed.coverage, 0.02);
    for (const double factor :
         {first.score.stripes, first.score.uniformity, first.score.in_range}) {
        EXPECT_GT(factor, 0.3);
        EXPECT_LE(factor, 1);
    }
    double in_lamps = 0;
    const HitHistogram& h = first.histogram;
    for (int v = 0; v < h.height(); ++v)
        for (int u = 0; u < h.width(); ++u) in_lamps += h.at(u, v);
    EXPECT_GT(in_lamps / h.total(), 0.85);
    EXPECT_GE(placed.candidates.size(), 20u);
    for (const PlaneCandidate& c : placed.candidates)
        EXPECT_LE(c.score.objective(), first.score.objective() * (1 + 1e-12));
    EXPECT_EQ(placed.blocked, 0);
    EXPECT_TRUE(placed.diagnostics.empty());
}

TEST(PlaceLamps, RefusesViewsOfNothing) {
    const Scene scene(test::bonnet_model(1100, 1400, 60));
    Camera away = scene.camera;
    away.target = away.eye * 2 - away.target;
    EXPECT_THROW(place_lamps(scene.tracer, scene.model, away), Error);
}

} // namespace
} // namespace keiko
