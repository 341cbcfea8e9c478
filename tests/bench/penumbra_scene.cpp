#include "tests/bench/penumbra_scene.h"

#include "keiko/geometry/model/surface_model.h"

#include "tests/support/model_builder.h"
#include "tests/support/random.h"

#include <cmath>
#include <numbers>

namespace keiko::bench {
namespace {

using namespace test;

SurfaceModel on_ground(const SurfaceModel& body, const Box3& box, double below) {
    const std::array models{body, ground_plane(box.lower.z - below * box.size(), box)};
    return merge(models);
}

/// The box of the body alone, as the ground is far larger.
CPlane row_over(const Box3& box, int lamps) {
    constexpr double margin = 1.3, height = 0.8;
    const Vec3 middle = box.center();
    const double x = margin * box.extent().x, y = margin * box.extent().y;
    return {.origin = {middle.x - x / 2, middle.y - y / 2, box.upper.z + height * box.size()},
            .u = {x, 0, 0},
            .v = {0, y, 0},
            .lamps = lamps,
            .diameter = 0.01 * box.size()};
}

Vec3 eye_before(const Box3& box) {
    return box.center() + Vec3(-1.6, -1.1, 0.7) * box.size();
}

/// The body and the shadows around it fill the picture.
Camera camera_before(const Box3& box) {
    Camera camera;
    camera.eye = eye_before(box);
    camera.target = box.center();
    camera.vertical_fov = 24;
    return camera;
}

/// Receivers where rays from a standing eye into the box and its surroundings meet surfaces.
std::vector<Receiver> receivers_of(const Tracer& tracer, const Box3& box, std::size_t count) {
    constexpr double surroundings = 1.4;
    Random random(7);
    const Vec3 eye = eye_before(box);
    const Vec3 half = box.extent() * (surroundings / 2);
    std::vector<Receiver> receivers;
    while (receivers.size() < count) {
        Ray ray;
        ray.origin = eye;
        for (unsigned k = 0; k < 3; ++k)
            ray.direction[k] =
                uniform(random, box.center()[k] - half[k], box.center()[k] + half[k]) - eye[k];
        const auto hit = tracer.nearest(ray);
        if (!hit) continue;
        receivers.push_back(receiver_at(*hit, ray));
    }
    return receivers;
}

} // namespace

Receiver receiver_at(const Hit& hit, const Ray& ray) {
    const bool behind = hit.normal.dot(ray.direction) > 0;
    return {hit.position, behind ? -hit.normal : hit.normal, hit.root};
}

PenumbraScene::PenumbraScene(std::string scene, const SurfaceModel& body, double clearance,
                             int lamps, std::size_t points)
    : PenumbraScene(std::move(scene), Tracer(body).bounds(), body, clearance, lamps, points) {}

PenumbraScene::PenumbraScene(std::string scene, const Box3& box, const SurfaceModel& body,
                             double clearance, int lamps, std::size_t points)
    : PenumbraScene(std::move(scene), box, on_ground(body, box, clearance), lamps, points) {}

PenumbraScene::PenumbraScene(std::string scene, const Box3& box, const SurfaceModel& all, int lamps,
                             std::size_t points)
    : name(std::move(scene)),
      patches(all.patches.size()),
      faces(all.faces.size()),
      tracer(all, {.second_derivatives = true}),
      occluders(all, tracer),
      row(row_over(box, lamps)),
      camera(camera_before(box)),
      receivers(receivers_of(tracer, box, points)) {}

CPlane PenumbraScene::row_of(int lamps) const {
    CPlane other = row;
    other.lamps = lamps;
    return other;
}

SurfaceModel wavy_sheet(int along_x, int along_y) {
    constexpr double width = 1000, swell = 100; // mm
    const double omega = 2 * std::numbers::pi / width;
    NurbsSurface sheet;
    sheet.degree_u = sheet.degree_v = 3;
    const auto knots = [&](int spans) {
        std::vector<double> k;
        for (int i = -3; i <= spans + 3; ++i) k.push_back(i * width / spans);
        return k;
    };
    sheet.knots_u = knots(along_x), sheet.knots_v = knots(along_y);
    // A cubic B-spline with these control values meets the wave at its knots.
    const auto control = [&](int i, int spans) {
        const double step = width / spans;
        return std::sin(omega * (i - 1) * step) * 3 / (2 + std::cos(omega * step));
    };
    for (int i = 0; i < along_x + 3; ++i)
        for (int j = 0; j < along_y + 3; ++j)
            sheet.points.emplace_back((i - 1) * width / along_x, (j - 1) * width / along_y,
                                      swell * control(i, along_x) * control(j, along_y), 1);
    ModelBuilder builder;
    builder.nurbs(sheet);
    return builder.build();
}

} // namespace keiko::bench
