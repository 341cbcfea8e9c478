#include "keiko/files/photometric/luminaire_file.h"
#include "keiko/light/spotlight/luminaire.h"
#include "keiko/light/spotlight/spotlight.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/analytic_models.h"
#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace keiko {
namespace {

/// mm: a ball that hangs in the beams.
const Vec3 ball_center(300, 100, 1500);
constexpr double ball_radius = 450;

bool passes_ball(const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from, off = from - ball_center;
    const double t = std::clamp(-off.dot(way) / way.length2(), 0.0, 1.0);
    return (off + way * t).length() >= ball_radius;
}

/// The medium as its definition has it, sampled.
struct SampledMedium {
    const Medium& medium;

    Rgb extinction(const Vec3& x) const {
        if (const auto* layers = std::get_if<LayeredDensity>(&medium.density)) {
            double border = layers->border.height;
            for (const Wave& wave : layers->border.waves)
                border += wave.amplitude * sine(x.x, wave.wavelength.x, wave.phase.x) *
                          sine(x.y, wave.wavelength.y, wave.phase.y);
            return x.z > border ? layers->extinction_above : medium.extinction;
        }
        // Of the one grid below: it rises from 0.2 to 1.4 along x and falls to a quarter upwards.
        if (std::holds_alternative<GridDensity>(medium.density)) {
            const Vec3 at = (x - grid_low) / (grid_high - grid_low);
            for (unsigned k = 0; k < 3; ++k)
                if (at[k] < 0 || at[k] > 1) return {};
            return medium.extinction * ((0.2 + 1.2 * at.x) * (1 - 0.75 * at.z));
        }
        return medium.extinction;
    }
    Rgb transmittance(const Vec3& a, const Vec3& b) const {
        const double metres = (b - a).length() / 1000;
        Rgb depth;
        const bool even = std::holds_alternative<HomogeneousDensity>(medium.density);
        const int steps = even ? 1 : 300;
        for (int i = 0; i < steps; ++i) depth += extinction(a + (b - a) * ((i + 0.5) / steps));
        depth = depth * (metres / steps);
        return {std::exp(-depth.r), std::exp(-depth.g), std::exp(-depth.b)};
    }

    static double sine(double x, double length, double phase) {
        return std::sin(2 * std::numbers::pi * x / length + phase * std::numbers::pi / 180);
    }
    static inline const Vec3 grid_low{-2600, -2500, -100}, grid_high{2400, 2500, 3100};
};

/// lx across the way of the light at a point, no medium; where the light comes from there.
struct Arriving {
    Rgb illuminance{};
    Vec3 origin{0};
};

Arriving arriving(const LightSource& source, const Vec3& x) {
    if (const auto* sun = std::get_if<Sun>(&source)) {
        // The window is the rectangle y = -2400, |x| <= 900, 500 <= z <= 2600.
        const Vec3 d = sun->direction.normalized();
        const double way = (x.y + 2400) / d.y;
        const Vec3 at = x - d * way;
        const bool in = way >= 0 && std::abs(at.x) <= 900 && at.z >= 500 && at.z <= 2600;
        return {in ? sun->illuminance : Rgb(), at};
    }
    const auto lamp = [&](const auto& light) {
        const double r2 = (x - light.position).length2() / 1e6;
        return Arriving{intensity_towards(light, x) * (1 / r2), light.position};
    };
    if (const auto* point = std::get_if<Spotlight>(&source)) return lamp(*point);
    return lamp(std::get<Luminaire>(source));
}

/// The sum of the definition by the midpoint rule, evenly along the ray.
Rgb marched(const LightRig& rig, const Segment& ray) {
    constexpr int steps = 6000;
    const SampledMedium medium{*rig.medium};
    const Vec3 way = ray.b - ray.a, direction = way.normalized();
    const double step = way.length() / 1000 / steps;
    Rgb sum, depth;
    for (int i = 0; i < steps; ++i) {
        const Vec3 x = ray.a + way * ((i + 0.5) / steps);
        const Rgb extinction = medium.extinction(x);
        const Rgb to_eye = depth + extinction * (step / 2);
        depth += extinction * step;
        const Arriving light = arriving(rig.sources.front(), x);
        if (light.illuminance == Rgb() || !passes_ball(light.origin, x)) continue;
        const double deviation = direction.dot((light.origin - x).normalized());
        const double phase =
            (1 + 6 * std::pow((1 + deviation) / 2, 8)) / (4 * std::numbers::pi * (1 + 6.0 / 9));
        sum += light.illuminance * extinction * rig.medium->albedo *
               medium.transmittance(light.origin, x) *
               Rgb(std::exp(-to_eye.r), std::exp(-to_eye.g), std::exp(-to_eye.b)) * (phase * step);
    }
    return sum;
}

std::vector<LightSource> lights() {
    const Vec3 above(-200, 200, 3000);
    std::vector<double> angles, candela;
    for (int i = 0; i <= 18; ++i) angles.push_back(5 * i), candela.push_back(900 - 2.5 * i * i);
    const auto table = std::make_shared<const IntensityTable>(
        angles, std::vector<double>{0}, candela, PlaneSymmetry::axial, TableInterpolation::cosine);
    Luminaire street{.position = above, .aim = Vec3(-200, 200, 0)};
    street.web = std::make_shared<const PhotometricWeb>(
        read_luminaire(test::repository("tests/data/oracle/photometric_files/sym2.ldt")));
    street.spin = 20;
    return {Spotlight{.position = above, .aim = Vec3(0), .half_angle = 60, .profile = table},
            street,
            Spotlight{.position = {-2300, -300, 1600},
                      .aim = {2000, 200, 1200},
                      .half_angle = 34,
                      .profile = EdgeProfile{BeamEdge::mixed, 0.4},
                      .intensity = {900, 800, 600},
                      .reference = {0, 1, 0},
                      .half_angle_across = 14},
            Sun{.direction = {0.1, 1, -0.35},
                .illuminance = {50000, 45000, 40000},
                .windows = {Window{{{-900, -2400, 500},
                                    {900, -2400, 500},
                                    {900, -2400, 2600},
                                    {-900, -2400, 2600}}}}}};
}

std::vector<Medium> media() {
    const Medium even{
        .extinction = {0.1, 0.15, 0.25}, .albedo = {0.9, 0.8, 0.7}, .phase = HazePhase{6}};
    Medium noise = even, grid = even;
    noise.density = LayeredDensity{{1100, noise_waves(250, 1500)}, Rgb(0.02)};
    const Vec3 low = SampledMedium::grid_low, high = SampledMedium::grid_high;
    std::vector<double> nodes;
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x) nodes.push_back((0.2 + 0.4 * x) * (1 - 0.375 * z));
    grid.density = GridDensity{
        std::make_shared<const VoxelDensity>(low, high, std::array{4, 2, 3}, std::move(nodes))};
    return {even, noise, grid};
}

/// Definition against intervals, closed forms and refined quadrature, for each kind of light in
/// each kind of medium, past a ball.
TEST(Fog, IsWhatItsDefinitionComesTo) {
    const SurfaceModel ball =
        test::sphere_model(Affine::translate(ball_center) * Affine::scale(ball_radius));
    const Tracer tracer(ball);
    const Occluders occluders(ball, tracer);
    const std::vector<Segment> rays{{{-2400, -2300, 1300}, {2300, 2200, 400}},
                                    {{-2400, -2300, 1300}, {2200, 1500, 1150}},
                                    {{-2400, -2300, 1300}, {2300, 300, 100}}};
    int light = 0, cut = 0;
    for (const LightSource& source : lights()) {
        for (std::size_t m = 0; m < media().size(); ++m) {
            const LightRig rig{
                .name = "", .sources = {source}, .ambient = Rgb(0), .medium = media()[m]};
            const VolumetricShadows shadows(rig, &occluders, tracer, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Rgb exact = luminance_along(rig, rays[i], Rgb(0), shadows.visible());
                const Rgb shown = luminance_along(rig, rays[i], Rgb(0), shadows.visible(),
                                                  picture_scattering_tolerance);
                const Rgb expected = marched(rig, rays[i]);
                cut += luminance_along(rig, rays[i], Rgb(0)).g > 1.01 * exact.g;
                for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
                    EXPECT_NEAR(exact.*channel, expected.*channel, 1e-3 * expected.*channel)
                        << "light " << light << ", medium " << m << ", ray " << i;
                    EXPECT_NEAR(shown.*channel, exact.*channel, 1e-4 * exact.*channel)
                        << "light " << light << ", medium " << m << ", ray " << i;
                }
            }
        }
        ++light;
    }
    EXPECT_GT(cut, 6); // the ball's shadow takes part
}

} // namespace
} // namespace keiko
