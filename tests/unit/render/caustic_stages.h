#pragma once

#include "keiko/light/luminance/fresnel.h"
#include "keiko/render/caustics/caustics.h"
#include "keiko/render/shading/picture.h"

#include "tests/support/shapes.h"

#include <cmath>
#include <numbers>

namespace keiko::test {

/// A body and a floor, the last face, under lights.
struct CausticStage {
    SurfaceModel model;
    Tracer tracer;
    std::vector<Material> materials;
    LightRig rig{};

    CausticStage(SurfaceModel body, const Material& material)
        : model(std::move(body)), tracer(model, {.second_derivatives = true}) {
        materials.assign(model.faces.size(), material);
        materials.back() = Material();
        materials.back().diffuse = Rgb(0.5), materials.back().refractive_index = 1;
    }
    std::uint32_t floor() const { return static_cast<std::uint32_t>(model.faces.size() - 1); }
    /// A piece of the floor, `wide` mm.
    SurfaceFootprint piece(const Vec3& middle, double wide = 1e-3) const {
        return {0, floor(), middle, {0, 0, 1}, {wide, 0, 0}, {0, wide, 0}};
    }
};

inline Material perfect_mirror() {
    Material mirror;
    mirror.metal = MetalIndex{Rgb(1), Rgb(1e9)};
    return mirror;
}

inline Material clear_glass(double n, double absorption = 0) {
    Material glass;
    glass.diffuse = Rgb(0), glass.refractive_index = n, glass.glass = Glass{Rgb(absorption), 0};
    return glass;
}

constexpr double lux = 1000; ///< of the sun
constexpr double floor_half = 2000;
constexpr double ball_radius = 50, ball_height = 90, index = 1.5;

/// A ball of glass over a floor.
inline CausticStage ball_lens(const LightSource& light, double absorption = 0) {
    ShapeBuilder builder;
    builder.face(sphere({0, 0, ball_height}, ball_radius));
    builder.face({rectangle(-floor_half, floor_half, -floor_half, floor_half, 0)});
    CausticStage stage(builder.model(), clear_glass(index, absorption));
    stage.rig.sources = {light};
    return stage;
}

/// A ray straight down past the middle of the ball at `b`: how far from the middle of the floor it
/// arrives, and with what share of its light.
struct Thrown {
    double to = 0, share = 0;
};
inline Thrown thrown(double b) {
    const double i = std::asin(b / ball_radius), r = std::asin(b / ball_radius / index);
    const double turned = 2 * (i - r); // towards the middle
    const double out =
        i + std::numbers::pi - 2 * r; // angle of the place where it leaves, from the top
    const double x = ball_radius * std::sin(out), z = ball_radius * std::cos(out);
    const double f = fresnel_dielectric(std::cos(i), index);
    return {x - std::tan(turned) * (ball_height + z), (1 - f) * (1 - f)};
}

inline Sun sun_above() {
    return {.direction = {0, 0, -1}, .illuminance = Rgb(lux)};
}

/// Illuminance at `rho` from the middle by the rays straight down that arrive there.
inline double under_ball(double rho) {
    double sum = 0;
    constexpr int steps = 2000;
    for (int i = 0; i < steps; ++i)
        for (const double side : {-1.0, 1.0}) {
            const auto miss = [&](double b) { return thrown(b).to - side * rho; };
            double low = ball_radius * (i + 1e-6) / steps, high = low + ball_radius / steps;
            if (i + 1 == steps || (miss(low) < 0) == (miss(high) < 0)) continue;
            const bool rises = miss(low) < 0;
            for (int k = 0; k < 50; ++k) {
                const double middle = (low + high) / 2;
                ((miss(middle) < 0) == rises ? low : high) = middle;
            }
            constexpr double h = 1e-5;
            const double slope = (thrown(low + h).to - thrown(low - h).to) / (2 * h);
            sum += lux * thrown(low).share * low / (rho * std::abs(slope));
        }
    return sum;
}

inline CausticSpec spec_of(int interfaces, int detail = 128) {
    return {.detail = detail, .interfaces = interfaces, .min_weight = 0.05};
}

} // namespace keiko::test
