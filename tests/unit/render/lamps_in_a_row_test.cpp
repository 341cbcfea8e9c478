#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/light/luminance/fresnel.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/math/axes.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace keiko {
namespace {

using test::flat_plate;
using test::Stage;

constexpr double glass = 30; ///< refractive index of the mirror
constexpr double never = std::numeric_limits<double>::infinity();

const SphereLight globe{{-150, 1700, 1300}, 300, Rgb(100, 500, 900)};
const PolygonLight panel{
    {{-1500, 5000, 300}, {1500, 5000, 300}, {1500, 5000, 3600}, {-1500, 5000, 3600}}, Rgb(300)};
/// Tubes along x, 3 m behind the plate's middle: between the globe and the panel.
CPlane tubes() {
    CPlane row;
    row.origin = {-4000, 3000, 600};
    row.u = {8000, 0, 0};
    row.v = {0, 0, 2200};
    row.lamps = 4;
    row.diameter = 160;
    row.luminance = Rgb(900, 700, 200);
    row.mirror = MirrorModel::exact;
    return row;
}

/// Distance along a unit direction to the globe.
double to_globe(const Vec3& from, const Vec3& way) {
    const Vec3 off = globe.center - from;
    const double along = off.dot(way);
    const double square = along * along - off.length2() + globe.radius * globe.radius;
    return square > 0 && along > 0 ? along - std::sqrt(square) : never;
}
double to_panel(const Vec3& from, const Vec3& way) {
    const double t = (5000 - from.y) / way.y;
    const Vec3 at = from + way * t;
    return t > 0 && std::abs(at.x) < 1500 && at.z > 300 && at.z < 3600 ? t : never;
}
double to_tubes(const Vec3& from, const Vec3& way) {
    const CPlaneFrame frame(tubes());
    double nearest = never;
    for (int i = 0; i < frame.lamps; ++i) {
        const Vec3 off = frame.at(0, frame.axis(i)) - from;
        const double a = way.y * way.y + way.z * way.z, b = off.y * way.y + off.z * way.z;
        const double c = off.y * off.y + off.z * off.z - frame.radius() * frame.radius();
        if (b > 0 && b * b > a * c) nearest = std::min(nearest, (b - std::sqrt(b * b - a * c)) / a);
    }
    return nearest;
}

/// Luminance along a ray that meets nothing but lights, in the medium of the rig.
double green_along(const Vec3& from, const Vec3& way, const LightRig& rig, bool with_tubes) {
    const double g = to_globe(from, way), p = to_panel(from, way);
    const double t = with_tubes ? to_tubes(from, way) : never, nearest = std::min({g, p, t});
    if (nearest == never) return rig.medium ? 0 : 7; // the background lies infinitely far
    const double own = nearest == g ? 500 : nearest == p ? 300 : 700;
    return rig.medium ? own * transmittance(*rig.medium, {from, from + way * nearest}).g : own;
}

/// Pixels that differ from the mean over many rays by more than `small`, and by how much. The rays
/// are a lattice without rows along the sides of a lamp.
struct Difference {
    double largest = 0;
    int many = 0, compared = 0;
};

Difference to_rays(const Stage& stage, bool with_tubes, double small) {
    const Film film = stage.render({.aovs = {}, .edge_samples = 1});
    constexpr int rays = 144;
    constexpr double step = 89.0 / rays; // of neighbouring numbers of Fibonacci's
    Difference difference;
    for (int y = 0; y < stage.camera.height; ++y)
        for (int x = 0; x < stage.camera.width; ++x) {
            double mean = 0;
            bool whole = true;
            for (int i = 0; i < rays; ++i) {
                const double up = i * step + 0.5 / rays;
                const Ray ray = stage.camera.ray(x + (i + 0.5) / rays, y + up - std::floor(up));
                const Vec3 at = ray.at(-ray.origin.z / ray.direction.z);
                const Vec3 way(ray.direction.x, ray.direction.y, -ray.direction.z);
                whole = whole && way.z > 0 && std::abs(at.x) < 1000 && std::abs(at.y) < 1000;
                double seen =
                    green_along(at, way, stage.rig, with_tubes) * fresnel_dielectric(way.z, glass);
                if (stage.rig.medium) seen *= transmittance(*stage.rig.medium, {ray.origin, at}).g;
                mean += seen / rays;
            }
            if (!whole) continue;
            const double off = std::abs(static_cast<double>(film.color.pixel(x, y)[1]) - mean);
            difference.largest = std::max(difference.largest, off);
            difference.many += off > small, ++difference.compared;
        }
    return difference;
}

Stage mirror(std::vector<LightSource> sources) {
    Stage stage(flat_plate(), glass);
    for (Material& material : stage.materials) material.diffuse = Rgb(0);
    stage.rig.sources = std::move(sources);
    return stage;
}

/// The rig's order is not that of the distances. At a tube's edge a pixel as wide as these is 2 %
/// of it off; where a globe's edge crosses one, both cover the pixel independently of each other.
TEST(LampsInARow, NearestHidesWhatIsBehind) {
    const Difference difference = to_rays(mirror({panel, tubes(), globe}), true, 21);
    EXPECT_GT(difference.compared, 1000);
    EXPECT_LT(difference.largest, 70); // a tenth of a tube
    EXPECT_LT(difference.many, difference.compared / 50);
}

TEST(LampsInARow, FogDimsEachFromItsOwnDistance) {
    Stage stage = mirror({panel, globe});
    stage.rig.medium = Medium{.extinction = Rgb(0.1, 0.2, 0.3)};
    const Difference difference = to_rays(stage, false, 2);
    EXPECT_GT(difference.compared, 1000);
    EXPECT_LT(difference.largest, 8); // of 500
    EXPECT_LT(difference.many, difference.compared / 50);
    stage.rig.sources.emplace_back(tubes());
    EXPECT_LT(to_rays(stage, true, 2).largest, 25); // a tenth of a tube behind 3 m of fog
}

/// Illuminance of a place of the plate by a panel and a globe through fog, by many small parts.
double lux_in_fog(const Vec3& at, const Medium& fog) {
    constexpr int n = 400;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const Vec3 place(-1500 + 3000 * (i + 0.5) / n, 5000, 300 + 3300 * (k + 0.5) / n);
            const Vec3 way = place - at;
            const double r2 = way.length2();
            sum += 300 * way.z * way.y / (r2 * r2) * (3000.0 / n) * (3300.0 / n) *
                   transmittance(fog, {place, at}).g;
        }
    const Vec3 axis = (globe.center - at).normalized();
    const Vec3 x = any_perpendicular(axis).normalized(), y = axis.cross(x);
    const double versine =
        1 - std::sqrt(1 - std::pow(globe.radius / (globe.center - at).length(), 2));
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const double cosine = 1 - versine * (i + 0.5) / n,
                         sine = std::sqrt(1 - cosine * cosine);
            const double phi = 2 * std::numbers::pi * (k + 0.5) / n;
            const Vec3 way = axis * cosine + (x * std::cos(phi) + y * std::sin(phi)) * sine;
            sum += 500 * std::max(0.0, way.z) * 2 * std::numbers::pi * versine / (n * n) *
                   transmittance(fog, {at + way * to_globe(at, way), at}).g;
        }
    return sum;
}

TEST(LampsInARow, PanelsAndGlobesLightAPlateThroughFog) {
    Stage stage(flat_plate(), 1);
    stage.rig.sources = {panel, globe};
    const Medium fog{.extinction = Rgb(0.1, 0.2, 0.3)};
    stage.rig.medium = fog;
    const Film film = stage.render();
    for (const auto& [x, y] : {std::pair(48, 27), std::pair(30, 20), std::pair(60, 33)}) {
        const Ray ray = stage.camera.ray(x + 0.5, y + 0.5);
        const Vec3 at = ray.at(-ray.origin.z / ray.direction.z);
        const double seen = lambert_luminance(Rgb(0.2), Rgb(lux_in_fog(at, fog))).g *
                            transmittance(fog, {ray.origin, at}).g;
        EXPECT_NEAR(film.color.pixel(x, y)[1], seen, 3e-3 * seen) << x << ' ' << y;
    }
}

} // namespace
} // namespace keiko
