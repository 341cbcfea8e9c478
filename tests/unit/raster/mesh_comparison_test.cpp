#include "keiko/raster/mesh_comparison.h"

#include "keiko/base/units.h"
#include "keiko/raster/mirror_images.h"
#include "keiko/raster/shading_rule.h"

#include "tests/support/analytic_models.h"
#include "tests/support/hand_mesh.h"
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace keiko {
namespace {

/// Lamps over and before a body at the origin, for an eye on the x axis.
LightRig rig(double x = 400) {
    CPlane plane;
    plane.origin = Vec3(x, -2000, -2000);
    plane.u = Vec3(0, 4000, 0), plane.v = Vec3(0, 0, 4000);
    plane.lamps = 40, plane.diameter = 50;
    LightRig rig;
    rig.sources.emplace_back(plane);
    return rig;
}

SurfaceModel sphere_model() {
    return test::sphere_model(test::stretched(Vec3(30), Vec3(0, 0, 1), Vec3(0)));
}

/// A sphere of 30 mm, exact and in triangles, in one view.
struct ComparedSphere {
    explicit ComparedSphere(SurfaceMesh triangles, double fov = 40)
        : mesh(std::move(triangles)),
          camera(camera_of(fov)),
          tracer(model, {.second_derivatives = true}),
          view(mesh, camera),
          truth(mirror_picture(tracer, model, camera, lamps)),
          shown(mirror_picture(view, lamps)) {}

    static Camera camera_of(double fov) {
        Camera camera = test::camera_on_x(100, 200, 200);
        camera.vertical_fov = fov;
        return camera;
    }
    MeshErrors errors() const { return mesh_errors(truth, shown, camera); }

    SurfaceModel model = sphere_model();
    SurfaceMesh mesh;
    Camera camera;
    RigPlanes lamps{rig()};
    Tracer tracer;
    MeshView view;
    MirrorPicture truth, shown;
};

TEST(MeshErrors, FallWithTheSquareOfTheCells) {
    const MeshErrors coarse = ComparedSphere(test::sphere_mesh(30, 20)).errors();
    const MeshErrors fine = ComparedSphere(test::sphere_mesh(30, 80)).errors();
    EXPECT_GT(coarse.compared, 3000U);
    EXPECT_GT(coarse.wrong, 4 * fine.wrong);
    EXPECT_NEAR(coarse.at_lamps.p99 / fine.at_lamps.p99, 16, 4);
    EXPECT_GT(coarse.missed.all, fine.missed.all); // polygons lie within their circle
    EXPECT_EQ(coarse.added.all, 0U);
    EXPECT_EQ(coarse.missed.inside, 0U);
}

TEST(MeshErrors, TellThePlantedTurnOfNormals) {
    constexpr double turn = 0.01;
    SurfaceMesh mesh = test::sphere_mesh(30, 400);
    for (Vec3& normal : mesh.normals)
        normal = Vec3(normal.x, normal.y * std::cos(turn) - normal.z * std::sin(turn),
                      normal.y * std::sin(turn) + normal.z * std::cos(turn));
    const ComparedSphere sphere(std::move(mesh));
    const MeshErrors errors = sphere.errors();
    // A turn about the x axis turns a normal by its distance from that axis.
    double most = 0;
    for (int y = 0; y < sphere.truth.height; ++y)
        for (int x = 0; x < sphere.truth.width; ++x)
            if (const MirrorPixel& pixel = sphere.truth.at(x, y);
                pixel.distance > 0 && pixel.face == sphere.shown.at(x, y).face)
                most = std::max(most, turn * std::hypot(pixel.met.normal.y, pixel.met.normal.z));
    EXPECT_NEAR(errors.normal.largest, radians_to_degrees(most) * 3600,
                0.02 * errors.normal.largest);
}

TEST(MeshErrors, FindAHoleInsideAFace) {
    SurfaceMesh mesh = test::sphere_mesh(30, 40);
    const ComparedSphere whole(mesh);
    const std::uint32_t middle = whole.view.items().at(100, 100);
    mesh.triangles.erase(mesh.triangles.begin() + middle);
    mesh.faces.erase(mesh.faces.begin() + middle);
    const ComparedSphere holed(std::move(mesh));
    // The far side of the sphere is seen through the hole: by another depth, not by another face.
    EXPECT_EQ(holed.errors().missed.inside, 0U);
    EXPECT_GT(holed.errors().wrong, whole.errors().wrong);
}

TEST(MeshErrors, CountPixelsOfOtherFaces) {
    SurfaceMesh mesh = test::sphere_mesh(30, 40);
    const ComparedSphere right(mesh);
    const std::uint32_t middle = right.view.items().at(100, 100);
    std::size_t pixels = 0;
    for (const std::uint32_t triangle : right.view.items().shown)
        pixels += triangle == middle ? 1 : 0;
    mesh.faces[middle] = 2;
    const MeshErrors errors = ComparedSphere(std::move(mesh)).errors();
    EXPECT_EQ(errors.other_face.all, pixels);
    EXPECT_EQ(errors.other_face.inside, pixels);
    EXPECT_EQ(right.errors().other_face.all, 0U);
}

TEST(MeshErrors, CompareNothingBeforeARigBehindTheBody) {
    Camera camera = test::camera_on_x(100, 100, 100);
    camera.vertical_fov = 10; // of the sphere's middle, which mirrors to the front
    const SurfaceModel model = sphere_model();
    const SurfaceMesh mesh = test::sphere_mesh(30, 20);
    const RigPlanes behind(rig(-400));
    const MirrorPicture truth =
        mirror_picture(Tracer(model, {.second_derivatives = true}), model, camera, behind);
    const MirrorPicture shown = mirror_picture(MeshView(mesh, camera), behind);
    const MeshErrors errors = mesh_errors(truth, shown, camera);
    EXPECT_EQ(errors.body, 10000U);
    EXPECT_EQ(errors.compared, 0U);
    EXPECT_FALSE(most_wrong_place(truth, shown, 20).has_value());
}

TEST(MeshErrors, CountLampsThatTheMeshAloneMirrors) {
    MirrorPicture truth{4, 1, std::vector<MirrorPixel>(4)};
    for (MirrorPixel& pixel : truth.pixels) pixel.face = 1, pixel.met = {100, Vec3(1, 0, 0)};
    MirrorPicture shown = truth;
    shown.pixels[1].coverage = 1, shown.pixels[1].distance = 300; // a lamp that is not there
    shown.pixels[2].coverage = 0.3;                               // a part of one beside its row
    shown.pixels[3].face = 2, shown.pixels[3].coverage = 1;
    const MeshErrors errors = mesh_errors(truth, shown, test::camera_on_x(100, 4, 1));
    EXPECT_EQ(errors.compared, 2U);
    EXPECT_EQ(errors.wrong, 2U);
    EXPECT_EQ(errors.reversed, 1U);
    EXPECT_EQ(errors.other_face.all, 1U);
    EXPECT_EQ(errors.at_lamps.largest, 0); // the surface mirrors no lamp to be displaced
    const Image picture = wrong_image(truth, shown);
    std::size_t red = 0;
    for (int x = 0; x < 4; ++x) red += *picture.pixel(x, 0) > 2 * picture.pixel(x, 0)[2] ? 1 : 0;
    EXPECT_EQ(red, errors.wrong);
    EXPECT_EQ(most_wrong_place(truth, shown, 2), Vec2(2, 1));
}

TEST(MeshErrors, DisplacementIsThatOfATurnedMirror) {
    constexpr double turn = 0.02, distance = 3000;
    Ray ray;
    ray.origin = Vec3(0, 0, 100), ray.direction = Vec3(0, 0, -1);
    const MetSurface truth{100, Vec3(0, 0, 1)}, shown{100, Vec3(std::sin(turn), 0, std::cos(turn))};
    EXPECT_NEAR(mirror_displacement(ray, truth, shown, distance), distance * std::sin(2 * turn),
                1e-9);
    EXPECT_NEAR(normal_error(truth.normal, -shown.normal), turn, 1e-12);
}

TEST(FacetBands, AreWeakestUnderPhongAndStrongestUnderConstantShading) {
    const ComparedSphere sphere(test::sphere_mesh(30, 20), 12); // no outline in the picture
    const FacetBands bands = facet_bands(sphere.view, sphere.truth, sphere.shown);
    EXPECT_GT(bands.places, 1000U);
    const auto of = [&](MeshShading shading) {
        return bands.mesh[static_cast<std::size_t>(shading)];
    };
    EXPECT_LT(of(MeshShading::phong), of(MeshShading::gouraud));
    EXPECT_LT(of(MeshShading::gouraud), of(MeshShading::constant));
    EXPECT_LT(bands.truth, of(MeshShading::gouraud) / 2);
}

TEST(FacetBands, OfGouraudAreTheChangeOfSlopeAcrossTheBorder) {
    // Two facets that meet along z at y = 0 under normals that only the border's corners turn.
    const auto normal = [](double y) { return Vec3(1, y, 0).normalized(); };
    SurfaceMesh mesh;
    for (const double side : {-1.0, 1.0})
        test::add_triangle(mesh, {Vec3(0, 0, -400), Vec3(0, 0, 400), Vec3(0, 400 * side, 0)},
                           {normal(0), normal(0), normal(side)});
    Camera camera = test::camera_on_x(100, 41, 41, Projection::orthographic);
    MeshView view(mesh, camera);
    MirrorPicture flat = mirror_picture(view, RigPlanes(rig()));
    const double slope = (1 - std::sqrt(0.5)) / 400, pixel = camera.pixel_size();
    EXPECT_NEAR(facet_bands(view, flat, flat).mesh[1], 2 * slope * pixel, 1e-6);
}

} // namespace
} // namespace keiko
