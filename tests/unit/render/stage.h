#pragma once

#include "keiko/render/shading/integrator.h"

#include "tests/support/model_builder.h"

#include <utility>
#include <vector>

namespace keiko::test {

/// A flat mirror 2 m wide under twelve lamps at 2 m, seen from aside.
struct Stage {
    SurfaceModel model;
    Tracer tracer;
    std::vector<Material> materials;
    LightRig rig;
    Camera camera;

    explicit Stage(SurfaceModel m, double refractive_index = 1.5)
        : model(std::move(m)),
          tracer(model, {.second_derivatives = true, .clipping_only = false, .join = 0.5}),
          materials(model.faces.size()) {
        for (Material& material : materials) {
            material.diffuse = Rgb(0.1, 0.2, 0.3);
            material.refractive_index = refractive_index;
        }
        CPlane plane;
        plane.origin = {-1500, 2500, 2000}; // where the mirror image of the eye looks
        plane.u = {3000, 0, 0};
        plane.v = {0, 3000, 0};
        rig.sources = {plane};
        camera.eye = {0, -3000, 1500};
        camera.target = {0, 0, 0};
        camera.width = 96;
        camera.height = 54;
    }

    Film render(PictureOptions options = {}, int threads = 0) const {
        return keiko::render({tracer, materials, rig, Rgb(7)}, camera, options,
                             {.progress = {}, .stop = {}, .threads = threads});
    }
};

inline SurfaceModel flat_plate() {
    ModelBuilder builder;
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    return builder.build();
}

/// A gently domed plate: bicubic, 150 mm high.
inline void add_dome(ModelBuilder& builder) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j) {
            const bool middle = i % 3 != 0 && j % 3 != 0;
            points.emplace_back(-900 + 600 * i, -900 + 600 * j, middle ? 300 : 0);
        }
    builder.patch(3, 3, points);
}

inline SurfaceModel dome() {
    ModelBuilder builder;
    add_dome(builder);
    return builder.build();
}

} // namespace keiko::test
