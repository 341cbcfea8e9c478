#include "tests/bench/sphere_cluster.h"

#include "tests/support/analytic_models.h"
#include "tests/support/hand_mesh.h"

#include <cmath>
#include <random>

namespace keiko::bench {

SphereCluster::SphereCluster(int count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-1, 1), size(0.6, 1.4);
    while (static_cast<int>(spheres_.size()) < count) {
        const Vec3 center(place(random), place(random), place(random));
        if (center.length() > 1) continue;
        spheres_.push_back({center * 100, size(random) * 85 / std::cbrt(count)});
    }
}

Camera SphereCluster::camera(int side) {
    Camera camera = test::camera_on_x(420, side, side);
    camera.eye = Vec3(380, 150, 130);
    return camera;
}

SurfaceMesh SphereCluster::mesh(int cells) const {
    SurfaceMesh all;
    for (std::uint32_t i = 0; i < spheres_.size(); ++i) {
        const SurfaceMesh one = test::sphere_mesh(spheres_[i].radius, cells);
        for (const auto& [a, b, c] : one.triangles)
            test::add_triangle(
                all,
                {one.positions[a] + spheres_[i].center, one.positions[b] + spheres_[i].center,
                 one.positions[c] + spheres_[i].center},
                {one.normals[a], one.normals[b], one.normals[c]}, i + 1);
    }
    return all;
}

SurfaceModel SphereCluster::model() const {
    std::vector<SurfaceModel> models;
    for (const Sphere& sphere : spheres_)
        models.push_back(
            test::sphere_model(test::stretched(Vec3(sphere.radius), Vec3(0, 0, 1), sphere.center)));
    return merge(models);
}

std::optional<SphereCluster::Met> SphereCluster::first(const Ray& ray) const {
    std::optional<Met> first;
    const double square = ray.direction.length2();
    for (std::uint32_t i = 0; i < spheres_.size(); ++i) {
        const Vec3 way = ray.origin - spheres_[i].center;
        const double along = way.dot(ray.direction);
        const double inside =
            along * along - square * (way.length2() - spheres_[i].radius * spheres_[i].radius);
        if (!(inside >= 0)) continue;
        const double t = (-along - std::sqrt(inside)) / square;
        if (t > 0 && (!first || t < first->t)) first = Met{t, i};
    }
    return first;
}

ItemBuffer SphereCluster::seen(const Camera& camera) const {
    const PreparedCamera prepared(camera);
    ItemBuffer seen(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (const auto met = first(prepared.ray(x + 0.5, y + 0.5)))
                seen.shown[seen.index(x, y)] = met->sphere;
    return seen;
}

ItemBuffer faces_of(const SurfaceMesh& mesh, ItemBuffer triangles) {
    for (std::uint32_t& shown : triangles.shown)
        if (shown != no_index) shown = mesh.faces[shown] - 1;
    return triangles;
}

} // namespace keiko::bench
