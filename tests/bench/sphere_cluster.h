#pragma once

#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

#include <optional>
#include <vector>

namespace keiko::bench {

/// Spheres that pierce each other, met by rays in closed form.
class SphereCluster {
public:
    /// `count` of them at random places in a ball of radius 100 mm, the same each time.
    explicit SphereCluster(int count);

    /// A camera that sees all of them in `side` x `side` pixels.
    static Camera camera(int side);
    /// Triangles of all, each in `cells` x 2 `cells` cells; face i + 1 is sphere i.
    SurfaceMesh mesh(int cells) const;
    /// The exact surfaces, 8 patches each; face i is sphere i.
    SurfaceModel model() const;

    /// Place on a ray.
    struct Met {
        double t = 0; ///< along the ray, in lengths of its direction
        std::uint32_t sphere = 0;
    };
    /// The first sphere on a ray from outside, by the quadratic of each [Whitted1980].
    std::optional<Met> first(const Ray& ray) const;
    /// The sphere of each pixel.
    ItemBuffer seen(const Camera& camera) const;

private:
    struct Sphere {
        Vec3 center{0};
        double radius = 0;
    };
    std::vector<Sphere> spheres_;
};

/// The faces of a buffer of triangles, less 1.
ItemBuffer faces_of(const SurfaceMesh& mesh, ItemBuffer triangles);

} // namespace keiko::bench
