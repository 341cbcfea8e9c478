#pragma once

#include "keiko/render/lighting/light_samples.h"

#include "tests/support/model_builder.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace keiko::test {

/// A matt plate at z = 0 as seen from above in places `step` mm apart, from its middle on to rising
/// x and y, under lights and a screen that hides some of them.
class PlateSpots {
public:
    static constexpr int side = 17;
    static constexpr double step = 1;

    /// A screen from `corner` on, level.
    struct Screen {
        Vec3 corner;
        double width, depth;
    };

    explicit PlateSpots(LightSource light, const std::optional<Screen>& screen = {})
        : model_(model_of(screen)), rig_(rig_of(std::move(light))) {}

    const Integrator& integrator() const { return integrator_; }
    const ShadingGrid& grid() const { return grid_; }
    static constexpr Rectangle all() { return {0, 0, side - 1, side - 1}; }

private:
    static SurfaceModel model_of(const std::optional<Screen>& screen) {
        ModelBuilder builder;
        builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
        if (screen) builder.plane(screen->corner, {screen->width, 0, 0}, {0, screen->depth, 0});
        return builder.build();
    }
    static LightRig rig_of(LightSource light) {
        LightRig rig;
        rig.sources = {std::move(light)};
        return rig;
    }
    static std::vector<Material> matt(std::size_t count) {
        Material material;
        material.refractive_index = 1;
        return std::vector<Material>(count, material);
    }
    static TileRays from_above() {
        TileRays grid{side, side, {}, rays_through};
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) grid.places.push_back({x, y, grid.places.size()});
        return grid;
    }
    static Rays rays_through(std::span<const GridPlace> places) {
        Rays rays(places.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            rays[i].origin = {places[i].x * step, places[i].y * step, 1};
            rays[i].direction = {0, 0, -1};
        }
        return rays;
    }

    SurfaceModel model_;
    Tracer tracer_{model_, {.second_derivatives = true, .clipping_only = false, .join = 0.5}};
    Occluders occluders_{model_, tracer_};
    LightRig rig_;
    std::vector<Material> materials_ = matt(model_.faces.size());
    PictureScene scene_{tracer_, materials_, rig_, Rgb(0), &occluders_};
    PictureOptions options_{.aovs = {}, .tubes = TubeModel::preview};
    Integrator integrator_{scene_, options_};
    SampleBatch view_ = integrator_.view(from_above());
    ShadingGrid grid_{side, side, view_.points};
};

/// One thin lamp along y at z = 1000, from y = -500 to 500.
inline CPlane one_lamp() {
    CPlane plane;
    plane.origin = {-5, -500, 1000};
    plane.u = {0, 1000, 0};
    plane.v = {10, 0, 0};
    plane.lamps = 1;
    plane.diameter = 1;
    return plane;
}

} // namespace keiko::test
