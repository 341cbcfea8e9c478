#include "keiko/workflow/luminous_faces.h"

#include "keiko/api/scene.h"
#include "keiko/light/rig/primitive_lights.h"
#include "keiko/light/rig/surface_light.h"
#include "keiko/maps/surface_maps.h"
#include "keiko/workflow/hidden_faces.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <array>
#include <fstream>

namespace keiko {
namespace {

Material luminous(const Rgb& luminance) {
    Material material;
    material.emits = luminance;
    return material;
}

std::vector<LightSource> lights_of_model(const SurfaceModel& model, double deviation = 2e-3) {
    const std::vector<Material> materials(model.faces.size(), luminous(Rgb(7)));
    return luminous_faces(model, materials, {}, {}, deviation);
}

double lit_by(const std::vector<LightSource>& lights, const Vec3& point, const Vec3& normal) {
    double sum = 0;
    for (const LightSource& light : lights)
        sum += illuminance_from(light, {}, point, normal, Unoccluded()).g;
    return sum;
}

/// Each face is a panel, outwards, also where an instance mirrors it.
TEST(LuminousFaces, PolyhedronIsExact) {
    const BoxShape box{{-100, -50, 500}, {200, 30, 0}, {0, 150, 20}, {0, 0, 100}};
    SurfaceModel model = primitive_model(box, "box");
    const std::vector<LightSource> exact = lights_of(box, Rgb(7));
    const std::vector<LightSource> lights = lights_of_model(model);
    ASSERT_EQ(lights.size(), 6U);
    for (const LightSource& light : lights) EXPECT_FALSE(std::get<PolygonLight>(light).shown);
    for (const Vec3& point : {Vec3(0), Vec3(400, 100, 550), Vec3(10, 20, 900)})
        for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(-0.8, 0, 0.6), Vec3(0, 0, -1)})
            EXPECT_NEAR(lit_by(lights, point, normal), lit_by(exact, point, normal), 1e-9);
    Affine mirror;
    mirror.rows[0] = Vec3(-1, 0, 0);
    model.instances[0].transform = mirror;
    EXPECT_NEAR(lit_by(lights_of_model(model), Vec3(-400, 100, 550), {0.8, 0, 0.6}),
                lit_by(exact, Vec3(400, 100, 550), {-0.8, 0, 0.6}), 1e-9);
}

/// Patches of a tube in facets, and the tube itself.
TEST(LuminousFaces, TubeOfPatchesIsTheExactTube) {
    const FrustumShape tube{{-600, 200, 900}, {600, 250, 950}, 20, 20, false};
    const std::vector<LightSource> exact = lights_of(tube, Rgb(7));
    const SurfaceModel patches = primitive_model(tube, "tube");
    const std::vector<LightSource> lights = lights_of_model(patches);
    const std::vector<LightSource> fine = lights_of_model(patches, 1e-4);
    for (const Vec3& point : {Vec3(0), Vec3(900, 300, 0), Vec3(0, 0, 700)})
        for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(0, 0.8, 0.6)}) {
            const double whole = lit_by(exact, point, normal);
            EXPECT_GT(whole, 0.01);
            EXPECT_NEAR(lit_by(lights, point, normal), whole, 1e-3 * whole) << point << normal;
            EXPECT_NEAR(lit_by(fine, point, normal), whole, 1e-4 * whole) << point << normal;
        }
}

/// A board of squares and a soft one, held against 40000 panels of the map's own values.
TEST(LuminousFaces, MappedPanelHasTheLightOfItsMap) {
    const PlaneShape board{{-300, -200, 500}, {0, 400, 0}, {600, 0, 0}}; // shines down
    const SurfaceModel model = primitive_model(board, "board");
    Material material = luminous(Rgb(100, 50, 10));
    material.maps.push_back({.drives = MappedQuantity::emission});
    for (const auto& [kind, error] :
         {std::pair(TextureKind::checker, 2e-2), std::pair(TextureKind::fractal, 1e-2)}) {
        material.maps[0].texture.kind = kind;
        material.maps[0].texture.size = 220;
        const SurfaceMaps maps(material.maps);
        const std::vector<LightSource> lights = luminous_faces(model, {&material, 1}, {}, {});
        EXPECT_EQ(lights.size(), 128U);
        for (const Vec3& point : {Vec3(0), Vec3(-250, 100, 200), Vec3(900, 0, 100)}) {
            const Vec3 normal = Vec3(0, 0.2, 1).normalized();
            constexpr int side = 200;
            double exact = 0, whole = 0;
            for (int i = 0; i < side; ++i)
                for (int k = 0; k < side; ++k) {
                    const Vec3 u = board.u / side, v = board.v / side;
                    const Vec3 at = board.origin + u * i + v * k;
                    const PolygonLight cell{{at, at + u, at + u + v, at + v}, Rgb(1)};
                    const double light = illuminance_from(cell, {}, point, normal, Unoccluded()).g;
                    const MapPlace place{at + (u + v) / 2, Vec3(0, 0, -1), {}, u, v};
                    exact += 50 * light * maps.values(place).emission.g, whole += 50 * light;
                }
            EXPECT_LT(exact, 0.8 * whole);
            EXPECT_NEAR(lit_by(lights, point, normal), exact, error * whole) << point;
        }
    }
}

/// An L with a checker on both faces, held against small panels of the map's own values.
TEST(LuminousFaces, MappedPolygonShinesOnTheSidesThatItHas) {
    const PolygonShape shape{{{0, 0, 500},
                              {0, 600, 500},
                              {200, 600, 500},
                              {200, 200, 500},
                              {600, 200, 500},
                              {600, 0, 500}}}; // shines down
    const PlaneShape around = shape.around();
    const SurfaceModel model = primitive_model(shape, "L");
    Material material = luminous(Rgb(60));
    material.maps.push_back({.drives = MappedQuantity::emission});
    material.maps[0].texture.kind = TextureKind::checker;
    material.maps[0].projection.kind = ProjectionKind::parameter;
    material.maps[0].projection.scale = {3, 3};
    constexpr int side = 180;
    const Vec3 u = around.u / side, v = around.v / side;
    for (const bool both : {false, true}) {
        material.emits_both_ways = both;
        const std::vector<LightSource> lights = luminous_faces(model, {&material, 1}, {}, {});
        for (const Vec3& point : {Vec3(250, 250, 100), Vec3(50, 500, 900)}) {
            const Vec3 normal(0, 0, point.z < 500 ? 1 : -1);
            double exact = 0, whole = 0;
            for (int i = 0; i < side; ++i)
                for (int k = 0; k < side; ++k) {
                    const Vec3 at = around.origin + u * i + v * k;
                    const Vec3 middle = at + (u + v) / 2;
                    if (middle.x > 200 && middle.y > 200) continue;
                    const PolygonLight cell{{at, at + u, at + u + v, at + v}, Rgb(60), true};
                    const double lx = illuminance_from(cell, {}, point, normal, Unoccluded()).g;
                    whole += lx;
                    if ((3 * i / side + 3 * k / side) % 2 == 1) exact += lx;
                }
            const bool is_lit = both || point.z < 500;
            EXPECT_NEAR(lit_by(lights, point, normal), is_lit ? exact : 0, 3e-2 * whole)
                << both << point;
        }
    }
}

/// Solids that are not convex light as what is visible of them, one light each; a convex one of
/// patches does so by its faces.
TEST(LuminousFaces, ClosedBodiesAreOneLight) {
    const FrustumShape can{{0, 0, 500}, {0, 0, 700}, 60, 90, false};
    EXPECT_EQ(lights_of_model(primitive_model(can, "can")).size(), 1U);
    FrustumShape open = can;
    open.open = true;
    const std::vector<LightSource> pipe = lights_of_model(primitive_model(open, "pipe"));
    ASSERT_EQ(pipe.size(), 1U);
    const FrustumLight side{can.from, can.to, can.radius, can.to_radius, Rgb(7)};
    for (const Vec3& point : {Vec3(0), Vec3(0, 20, 1500), Vec3(300, 0, 600)})
        EXPECT_NEAR(lit_by(pipe, point, {0.6, 0, 0.8}), lit_by({side}, point, {0.6, 0, 0.8}), 1e-4);
    // Half of it mirrored is the other half, a part of its own.
    SurfaceModel halves =
        primitive_model(EllipsoidShape{{0, 0, 500}, {90, 0, 0}, {0, 90, 0}, {0, 0, 60}}, "egg");
    std::erase_if(halves.patches, [&](const Patch& patch) { return patch.map_u.begin >= 3; });
    halves.faces[0].patch_count = static_cast<std::uint32_t>(halves.patches.size());
    ASSERT_EQ(halves.patches.size(), 4U);
    halves.instances.push_back(halves.instances[0]);
    halves.instances[1].transform.rows[1] = Vec3(0, -1, 0);
    EXPECT_EQ(lights_of_model(halves).size(), 1U);
    std::vector<Material> two(3, luminous(Rgb(7)));
    two[1].emits = Rgb(9); // of an end, so that neither part is closed
    // The end of its own luminance is a panel, the others are sheets.
    EXPECT_EQ(luminous_faces(primitive_model(can, "can"), two, {}, {}).size(), 2U);
}

/// No ray from many sides meets them, and yet they close nothing: each is dark from within, where
/// neither shines, and bright from outside.
TEST(LuminousFaces, OpenPartsThatDoNotTouchAreSheets) {
    const auto dome = [](double x) {
        SurfaceModel egg = primitive_model(
            EllipsoidShape{{x, 0, 500}, {90, 0, 0}, {0, 90, 0}, {0, 0, 60}}, "dome");
        std::erase_if(egg.patches, [&](const Patch& patch) { return patch.map_u.begin >= 3; });
        egg.faces[0].patch_count = static_cast<std::uint32_t>(egg.patches.size());
        return egg;
    };
    const std::array apart{dome(0), dome(3000)};
    const std::vector<LightSource> lights = lights_of_model(merge(apart));
    ASSERT_EQ(lights.size(), 2U);
    for (const double x : {0.0, 3000.0}) {
        const Vec3 away(x > 0 ? 1 : -1, 0, 0); // from the other dome
        EXPECT_EQ(lit_by(lights, {x, 20, 490}, away), 0) << x;
        EXPECT_GT(lit_by(lights, {x, 600, 490}, {0, -1, 0}), 0.01) << x;
    }
}

/// The faces of an L, each a part, close it, whatever else has their luminance.
TEST(LuminousFaces, PartsThatTouchCloseABody) {
    const std::vector<Vec2> outline{{0, 0}, {600, 0}, {600, 200}, {200, 200}, {200, 600}, {0, 600}};
    std::vector<SurfaceModel> parts;
    PolygonShape top, bottom;
    for (std::size_t i = 0; i < 6; ++i) {
        const Vec3 at(outline[i].x, outline[i].y, 0);
        const Vec3 to(outline[(i + 1) % 6].x, outline[(i + 1) % 6].y, 0);
        parts.push_back(primitive_model(PlaneShape{at, to - at, {0, 0, 150}}, "side"));
        top.corners.push_back(at + Vec3(0, 0, 150));
        bottom.corners.insert(bottom.corners.begin(), at);
    }
    parts.push_back(primitive_model(top, "top"));
    parts.push_back(primitive_model(bottom, "bottom"));
    EXPECT_EQ(lights_of_model(merge(parts)).size(), 1U);
    parts.push_back(primitive_model(PlaneShape{{5000, 0, 0}, {90, 0, 0}, {0, 90, 0}}, "sheet"));
    const std::vector<LightSource> lights = lights_of_model(merge(parts));
    ASSERT_EQ(lights.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<ContourLight>(lights[0]));
    EXPECT_TRUE(std::holds_alternative<PolygonLight>(lights[1]));
}

/// From above a shelf hides the middle of the wall that it is on, and its dark side is not seen.
TEST(LuminousFaces, ShelfHidesTheWallBehindIt) {
    const PlaneShape wall{{-300, 0, 0}, {600, 0, 0}, {0, 0, 400}};
    const PlaneShape shelf{{-300, -150, 400}, {600, 0, 0}, {0, 150, 0}};
    const std::array both{primitive_model(wall, "wall"), primitive_model(shelf, "shelf")};
    const std::vector<LightSource> lights = lights_of_model(merge(both));
    ASSERT_EQ(lights.size(), 1U);
    // Over the front edge of the shelf the wall is seen up to this height.
    const Vec3 above(0, -600, 900), down = Vec3(0, 0.6, -0.8);
    PlaneShape seen = wall;
    seen.v.z = 400 - 150 * 500 / 450.0;
    const double exact = lit_by(lights_of(seen, Rgb(7)), above, down) +
                         lit_by(lights_of(shelf, Rgb(7)), above, down);
    EXPECT_NEAR(lit_by(lights, above, down), exact, 1e-5 * exact);
    // Back to back they hide nothing, and are panels.
    const PlaneShape under{{-300, 0, 0}, {600, 0, 0}, {0, 150, -50}};
    const std::array ridge{primitive_model(wall, "wall"),
                           primitive_model(PlaneShape{under.origin, under.v, under.u}, "under")};
    EXPECT_EQ(lights_of_model(merge(ridge)).size(), 2U);
}

/// A flat round face is one panel of its own area, nearly.
TEST(LuminousFaces, DiscOfAModelLosesLittleAtItsRim) {
    const DiscShape disc{{0, 0, 500}, {0, 0, -1}, 300};
    const std::vector<LightSource> lights = lights_of_model(primitive_model(disc, "disc"));
    ASSERT_EQ(lights.size(), 1U);
    const double exact = lit_by(lights_of(disc, Rgb(7)), Vec3(50, 0, 0), {0, 0, 1});
    EXPECT_NEAR(lit_by(lights, Vec3(50, 0, 0), {0, 0, 1}), exact, 3e-4 * exact);
}

TEST(LuminousFaces, DarkBodiesHaveNone) {
    const SurfaceModel model = primitive_model(DiscShape{{0, 0, 0}, {0, 0, 1}, 5}, "disc");
    EXPECT_TRUE(luminous_faces(model, std::vector<Material>(1), {}, {}).empty());
}

/// A lamp hides nothing, not even itself, and its scene needs no other light.
TEST(LuminousFaces, BodyLightsItsSceneAndCastsNoShadow) {
    const test::TemporaryFolder folder;
    const auto open = [&](const std::string& material) {
        const auto file = folder.path() / "scene.toml";
        std::ofstream(file) << "format = \"keiko-scene/1\"\n[[primitive]]\nkind = \"box\"\n"
                               "origin = [0, 0, -90]\nu = [9, 0, 0]\nv = [0, 9, 0]\nw = [0, 0, 9]\n"
                               "material = \"concrete\"\n[[model]]\nfile = \""
                            << test::repository("surfaces/wall.bpt").string()
                            << "\"\nmaterial = " << material << '\n';
        const std::filesystem::path inputs[] = {file};
        SceneOptions options;
        options.shadows = true;
        return open_scene(inputs, options);
    };
    const Ray through{.origin = {-1000, 0, 2000}, .direction = {1, 0, 0}};
    const Scene lamp = open("{ diffuse = 0, emits = 50 }"), wall = open("{ diffuse = 0 }");
    ASSERT_TRUE(lamp.rig);
    EXPECT_FALSE(wall.rig);
    EXPECT_EQ(lamp.rig->sources.size(), 1U);
    EXPECT_FALSE(lamp.occluders->tracer().nearest(through));
    EXPECT_TRUE(wall.occluders->tracer().nearest(through));
    EXPECT_TRUE(lamp.tracer.nearest(through));
    const std::uint32_t of_box = lamp.model.faces.back().id; // of the concrete, hidden
    const auto casters = occluders_without(lamp, {&of_box, 1}, {});
    EXPECT_FALSE(casters->tracer().nearest(through));
}

} // namespace
} // namespace keiko
