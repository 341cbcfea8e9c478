#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/light/rig/primitive_lights.h"
#include "keiko/light/rig/rig_areas.h"
#include "keiko/light/rig/surface_light.h"
#include "keiko/light/tubes/tube_irradiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
const Vec3 up(0, 0, 1), origin(0);
const SphereLight globe{{400, -300, 900}, 350, Rgb(10, 20, 30)};

/// The rectangle from a corner along u and v, in columns and rows that shine towards u x v.
std::vector<PolygonLight> panels(const Vec3& corner, const Vec3& u, const Vec3& v, int columns,
                                 int rows) {
    std::vector<PolygonLight> panels;
    for (int i = 0; i < columns; ++i)
        for (int k = 0; k < rows; ++k) {
            const Vec3 a = corner + u * (double(i) / columns) + v * (double(k) / rows);
            const Vec3 x = u / columns, y = v / rows;
            panels.push_back({{a, a + x, a + x + y, a + y}, Rgb(100, 200, 300)});
        }
    return panels;
}
const Vec3 corner(-300, 900, 700), along_u(0, 1500, 0), along_v(1100, 0, 200);
const PolygonLight whole = panels(corner, along_v, along_u * -1, 1, 1)[0];

std::vector<PolygonLight> parts(int columns, int rows) {
    return panels(corner, along_v, along_u * -1, columns, rows);
}

/// A tube in facets as wide as its half circumference in the mean is what the exact cylinder is.
TEST(AreaRig, TubeOfPanelsIsTheExactTube) {
    constexpr int sides = 256;
    const double radius = 90, r = radius * (pi / sides) / std::sin(pi / sides);
    const Vec3 a(-700, 250, 1100), b(500, 250, 1100), normal = Vec3(0.2, -0.1, 1).normalized();
    const auto rim = [&](const Vec3& end, int i) {
        const double angle = 2 * pi * i / sides;
        return end + Vec3(0, std::cos(angle), std::sin(angle)) * r;
    };
    double sum = 0;
    for (int i = 0; i < sides; ++i) {
        const PolygonLight facet{{rim(a, i), rim(a, i + 1), rim(b, i + 1), rim(b, i)}, Rgb(1)};
        PolygonLight outwards = facet;
        if (facet.normal().dot(facet.corners[0] - a) < 0)
            std::reverse(outwards.corners.begin(), outwards.corners.end());
        sum += illuminance_from(outwards, {}, origin, normal, Unoccluded()).g;
    }
    const TubeLamp tube{a, b, 2 * radius, Rgb(1)};
    const double exact =
        irradiance(tube, origin, normal, IntervalSet::whole(), TubeModel::cylinder).g;
    EXPECT_NEAR(sum, exact, 1e-4 * exact);
}

Rgb lit_by(const std::vector<LightSource>& lights, const std::optional<Medium>& medium,
           const Vec3& normal, const ClearCoat* coat = nullptr) {
    Rgb sum;
    for (const LightSource& light : lights)
        sum += illuminance_from(light, medium, origin, normal, Unoccluded(), TubeModel::automatic,
                                coat);
    return sum;
}

/// With its ends, from beside it and from beyond them.
TEST(AreaRig, PrimitiveCylinderIsTheExactTube) {
    CPlane row;
    row.origin = {-700, 100, 1100}, row.u = {1200, 0, 0};
    row.v = {0, 300, 0}, row.lamps = 1, row.diameter = 180, row.luminance = Rgb(1);
    row.luminous_caps = true, row.diffuse = TubeModel::cylinder;
    const TubeLamp lamp = lamps_of(row).at(0);
    const FrustumShape shape{lamp.a, lamp.b, 90, 90, false};
    const std::vector<LightSource> body = lights_of(shape, Rgb(1));
    for (const Vec3& normal : {up, Vec3(0.8, 0, 0.6), Vec3(-0.6, 0.64, -0.48)})
        for (const Vec3& at : {Vec3(0), Vec3(2500, 300, 900), Vec3(900, 260, 1090)}) {
            double sum = 0;
            for (const LightSource& part : body)
                sum += illuminance_from(part, {}, at, normal, Unoccluded()).g;
            const double exact = illuminance_from(row, {}, at, normal, Unoccluded()).g;
            EXPECT_NEAR(sum, exact, 1e-4 * exact + 1e-12) << at;
        }
}

/// A cone in four parts along it, through a coat and fog.
TEST(AreaRig, PartsOfAConeAddUpThroughACoatAndFog) {
    const ClearCoat coat(Rgb(0.5), 1.5);
    const Medium fog{.extinction = Rgb(0.3, 0.6, 1.2)};
    const FrustumLight cone{{-600, 150, 800}, {700, 150, 900}, 120, 240, Rgb(1)};
    std::vector<LightSource> parts;
    for (int i = 0; i < 4; ++i) {
        const auto at = [&](double t) { return cone.from + (cone.to - cone.from) * t; };
        const auto radius = [&](double t) { return 120 + 120 * t; };
        parts.emplace_back(FrustumLight{at(i / 4.0), at((i + 1) / 4.0), radius(i / 4.0),
                                        radius((i + 1) / 4.0), Rgb(1)});
    }
    for (const Vec3& normal : {up, Vec3(0.8, 0, 0.6), Vec3(-0.36, 0.48, 0.8)}) {
        const Rgb one = lit_by({cone}, fog, normal, &coat),
                  many = lit_by(parts, fog, normal, &coat);
        EXPECT_GT(many.b, 1e-3);
        EXPECT_NEAR(one.r, many.r, 1e-3 * many.r);
        EXPECT_NEAR(one.b, many.b, 1e-3 * many.b);
    }
}

/// A lobe of a cone is that of its parts, and of an ellipsoid that is a sphere the sphere's.
TEST(AreaRig, LobesOfCurvedLights) {
    const Vec3 eye = Vec3(-0.5, 0.3, 1).normalized();
    const Gloss gloss{.distribution = {DistributionKind::trowbridge_reitz, 0.15}};
    const GlossKernel kernel(gloss, up, eye);
    const auto lobe = [&](const std::vector<LightSource>& lights) {
        LightRig rig;
        rig.sources = lights;
        return glossy_luminance(rig, origin, kernel, Unoccluded(), GlossQuadrature::number).g;
    };
    const FrustumLight cone{{200, -500, 800}, {600, 300, 900}, 120, 240, Rgb(100)};
    FrustumLight first = cone, second = cone;
    first.to = second.from = Vec3(400, -100, 850), first.to_radius = second.radius = 180;
    const double undivided = lobe({cone});
    EXPECT_GT(undivided, 1);
    EXPECT_NEAR(undivided, lobe({first, second}), 1e-4 * undivided);
    const SphereLight ball{{400, -300, 900}, 350, Rgb(100)};
    const EllipsoidLight same{ball.center, {0, 350, 0}, {0, 0, 350}, {350, 0, 0}, Rgb(100)};
    EXPECT_NEAR(lobe({ball}), lobe({same}), 1e-4 * lobe({ball}));
}

TEST(AreaRig, LightIsLuminanceTimesProjectedSolidAngle) {
    for (const Vec3& normal : {up, Vec3(0.8, 0, 0.6)}) {
        const Rgb lx = illuminance_from(globe, {}, origin, normal, Unoccluded());
        const double omega = projected_solid_angle(globe, origin, normal);
        EXPECT_NEAR(lx.r, 10 * omega, 1e-12);
        EXPECT_NEAR(lx.b, 30 * omega, 1e-12);
    }
    EXPECT_EQ(illuminance_from(globe, {}, origin, -up, Unoccluded()), Rgb(0));
    LightRig rig;
    rig.sources = {globe, whole};
    EXPECT_EQ(PreparedRig(rig).lights.size(), 2U);
    EXPECT_TRUE(within_lamp(globe, globe.center));
    EXPECT_FALSE(within_lamp(globe, origin));
}

/// Through a coat and fog, with the horizon above and across the panel.
TEST(AreaRig, PartsOfAPanelAddUpThroughACoatAndFog) {
    const ClearCoat coat(Rgb(0.5), 1.5);
    const Medium fog{.extinction = Rgb(0.3, 0.6, 1.2)};
    for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.8, 0, 0.6), Vec3(-0.6, 0.64, -0.48)}) {
        const auto all = [&](const std::vector<PolygonLight>& lights) {
            Rgb sum;
            for (const PolygonLight& light : lights)
                sum += illuminance_from(light, fog, origin, normal, Unoccluded(),
                                        TubeModel::automatic, &coat);
            return sum;
        };
        const Rgb one = all({whole}), many = all(parts(12, 12));
        EXPECT_NEAR(one.r, many.r, 1e-3 * many.r + 1e-12);
        EXPECT_NEAR(one.b, many.b, 1e-3 * many.b + 1e-12);
    }
    EXPECT_GT(illuminance_from(whole, fog, origin, up, Unoccluded()).r, 1);
}

/// A sphere far larger than the lobe shows it all, whatever its width.
TEST(AreaRig, LobeWithinALightShowsItsWholeLuminance) {
    const SphereLight sky{{0, 0, 1000}, 999, Rgb(70)};
    const Vec3 eye = Vec3(0.3, 0.1, 1).normalized();
    LightRig rig;
    rig.sources = {sky};
    for (const double width : {0.002, 0.05}) {
        const Gloss gloss{.distribution = {DistributionKind::beckmann, width}};
        const GlossKernel kernel(gloss, up, eye);
        const Rgb seen = glossy_luminance(rig, origin, kernel, Unoccluded());
        EXPECT_NEAR(seen.g, 70, 0.5) << width;
    }
}

TEST(AreaRig, LobesOfPartsOfAPanelAddUp) {
    const Vec3 eye = Vec3(-0.5, 0.3, 1).normalized();
    const Gloss gloss{.distribution = {DistributionKind::trowbridge_reitz, 0.15}};
    const GlossKernel kernel(gloss, up, eye);
    const auto all = [&](const std::vector<PolygonLight>& lights, GlossQuadrature quadrature) {
        LightRig rig;
        rig.sources.assign(lights.begin(), lights.end());
        return glossy_luminance(rig, origin, kernel, Unoccluded(), quadrature).g;
    };
    const double many = all(parts(3, 3), GlossQuadrature::number);
    EXPECT_GT(many, 10);
    EXPECT_NEAR(all({whole}, GlossQuadrature::number), many, 1e-4 * many);
    EXPECT_NEAR(all({whole}, GlossQuadrature::picture), many, 5e-3 * many);
}

} // namespace
} // namespace keiko
