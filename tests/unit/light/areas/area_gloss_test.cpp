#include "keiko/light/areas/area_gloss.h"

#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/math/axes.h"

#include "tests/support/shows_below.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
const Vec3 up(0, 0, 1), here(0);

/// Unit direction in a Phong lobe, by two shares from 0 to 1 of its light.
Vec3 phong_direction(const Vec3& peak, double exponent, double u, double v) {
    const Vec3 x = any_perpendicular(peak).normalized(), y = peak.cross(x);
    const double cosine = std::pow(u, 1 / (exponent + 1)), sine = std::sqrt(1 - cosine * cosine);
    return peak * cosine + (x * std::cos(2 * pi * v) + y * std::sin(2 * pi * v)) * sine;
}

/// Share of a Phong lobe's light for which `counts(direction)` holds, by n x n directions.
template <class Counts>
double phong_share(const Vec3& peak, double exponent, int n, const Counts& counts) {
    int inside = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
            inside += counts(phong_direction(peak, exponent, (i + 0.5) / n, (k + 0.5) / n));
    return double(inside) / n / n;
}

/// Ceiling from x = 300 mm on, 4 m wide, 2.5 m above the point, along x or across.
PolygonLight ceiling(double length) {
    return {{{300, -2000, 2500},
             {300, 2000, 2500},
             {300 + length, 2000, 2500},
             {300 + length, -2000, 2500}},
            Rgb(1)};
}
bool on_ceiling(const PolygonLight& light, const Vec3& way) {
    if (!(way.z > 0)) return false;
    const Vec3 at = way * (2500 / way.z);
    return at.x > 300 && at.x < light.corners[2].x && std::abs(at.y) < 2000;
}

/// Share of a Phong lobe's light that a polygon above the horizon sends, with all of it less than
/// 90 degrees from the peak: the integral along its outline.
double phong_share(const PolygonLight& light, const Vec3& peak, double exponent) {
    double sum = 0;
    for (std::size_t i = 0; i < light.corners.size(); ++i) {
        const Vec3 a = light.corners[i], b = light.corners[(i + 1) % light.corners.size()];
        const Vec3 m = a.cross(b).normalized();
        const double h = peak.dot(m), c2 = 1 - h * h;
        const Vec3 nearest = (peak - m * h).normalized(), ahead = m.cross(nearest);
        const auto angle = [&](const Vec3& w) { return std::atan2(w.dot(ahead), w.dot(nearest)); };
        const auto rate = [&](double psi) {
            const double x = h * h + c2 * std::sin(psi) * std::sin(psi);
            return -std::expm1((exponent + 1) / 2 * std::log1p(-x)) / x;
        };
        Breakpoints range(angle(a), angle(b)); // anticlockwise about m
        for (const double off : {-6.0, -3.0, -1.5, 0.0, 1.5, 3.0, 6.0})
            range.cut_at(off / std::sqrt(exponent + 1));
        const double whole = sum_over_pieces(range, [&](double from, double to) {
            return integrate_adaptively(rate, from, to, 1e-9);
        });
        sum += h * whole;
    }
    return std::abs(sum) / (2 * pi);
}

/// Narrow lobes at any angle to the lines of the panel, up to the horizon and along the lines.
TEST(AreaGloss, PhongLobesAgreeWithTheIntegralAlongTheOutline) {
    constexpr double rounding = 1e-14; // of the closed form's terms
    int lit = 0;
    for (const double length : {3000.0, 60000.0})
        for (const double angle : {20.0, 60.0, 80.0, 86.0})
            for (const double exponent : {20.0, 300.0, 5000.0}) {
                const PolygonLight light = ceiling(length);
                const double theta = angle * pi / 180;
                const Vec3 eye(-std::sin(theta) * std::cos(0.1), -std::sin(theta) * std::sin(0.1),
                               std::cos(theta));
                const Gloss gloss{.distribution = {DistributionKind::phong, exponent}};
                const GlossKernel kernel(gloss, up, eye);
                const double closed =
                    phong_share(light, kernel.peak(), exponent) * gloss.reflectance(eye.z).g;
                lit += closed > 0.01;
                const auto width = width_of(light, here, up);
                ASSERT_TRUE(width);
                EXPECT_NEAR(AreaGloss(*width, kernel, 1e-6).integral().g, closed,
                            1e-5 * closed + rounding)
                    << length << ' ' << angle << ' ' << exponent;
                EXPECT_NEAR(AreaGloss(*width, kernel, 3e-3).integral().g, closed,
                            2e-3 * closed + rounding)
                    << length << ' ' << angle << ' ' << exponent;
            }
    EXPECT_GT(lit, 12);
}

/// Lobes of half vectors, narrow across the plane of incidence at grazing angles, by a panel in
/// 40 x 40 parts that has the sum of their light.
TEST(AreaGloss, PartsOfAPanelAddUpAtGrazingAngles) {
    const PolygonLight whole = ceiling(60000);
    const double theta = 82 * pi / 180;
    const Vec3 eye(-std::sin(theta), 0, std::cos(theta));
    const auto compare = [&](const auto& kernel) {
        constexpr int n = 40;
        double sum = 0;
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k) {
                PolygonLight part = whole;
                const auto place = [&](int a, int b) {
                    // Equal angles about the point along x.
                    const double first = std::atan(300 / 2500.0), last = std::atan(60300 / 2500.0);
                    return Vec3(2500 * std::tan(first + (last - first) * a / n),
                                -2000 + 4000.0 * b / n, 2500);
                };
                part.corners = {place(i, k), place(i, k + 1), place(i + 1, k + 1), place(i + 1, k)};
                if (const auto width = width_of(part, here, up))
                    sum += AreaGloss(*width, kernel, 1e-5).integral().g;
            }
        const auto width = width_of(whole, here, up);
        ASSERT_TRUE(width);
        EXPECT_GT(sum, 0.01);
        EXPECT_NEAR(AreaGloss(*width, kernel, 1e-6).integral().g, sum, 1e-4 * sum);
        EXPECT_NEAR(AreaGloss(*width, kernel, 3e-3).integral().g, sum, 3e-3 * sum);
    };
    for (const DistributionKind kind :
         {DistributionKind::beckmann, DistributionKind::trowbridge_reitz}) {
        const Gloss gloss{.distribution = {kind, 0.02}};
        compare(GlossKernel(gloss, up, eye));
        for (const Vec3& along : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}) {
            const Gloss brushed{.distribution = {kind, 0.01, 0.08}};
            compare(GlossKernel(brushed, up, eye, along));
        }
    }
    const Flakes flakes;
    compare(FlakeKernel(flakes, up, eye));
}

/// In fog what arrives is weighted by the lobe: that of the far end, for a lobe towards it.
TEST(AreaGloss, TransmittanceIsWeightedByTheLobe) {
    const PolygonLight light = ceiling(20000);
    const double theta = 70 * pi / 180, exponent = 2000;
    const Vec3 eye(-std::sin(theta), 0, std::cos(theta));
    const Gloss gloss{.distribution = {DistributionKind::phong, exponent}};
    const GlossKernel kernel(gloss, up, eye);
    const auto passed = [](const Vec3& place) { return std::exp(-place.length() / 3000); };
    double many = 0;
    constexpr int n = 500;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const Vec3 way = phong_direction(kernel.peak(), exponent, (i + 0.5) / n, (k + 0.5) / n);
            if (on_ceiling(light, way)) many += passed(way * (2500 / way.z)) / n / n;
        }
    many *= gloss.reflectance(eye.z).g;
    const auto width = width_of(light, here, up);
    ASSERT_TRUE(width);
    const AreaGloss lobe(*width, kernel, 3e-3);
    EXPECT_NEAR(lobe.integral([&](const Vec3& at) { return Rgb(passed(at)); }).g, many,
                3e-3 * many);
    EXPECT_GT(many, 0);
}

/// A wall hides the part of the panel that a narrow lobe shows, or the part that it does not show.
TEST(AreaGloss, VisibleShareIsThatOfTheLobe) {
    const PolygonLight light = ceiling(3000);
    const auto width = width_of(light, here, up);
    ASSERT_TRUE(width);
    const double theta = 30 * pi / 180, exponent = 400;
    const Vec3 eye(-std::sin(theta), 0, std::cos(theta));
    const Gloss gloss{.distribution = {DistributionKind::phong, exponent}};
    const GlossKernel kernel(gloss, up, eye);
    const AreaGloss lobe(*width, kernel, 1e-6);
    const double whole = phong_share(kernel.peak(), exponent, 500,
                                     [&](const Vec3& w) { return on_ceiling(light, w); });
    for (const double wall : {500.0, 1100.0, 1443.0, 1600.0, 2600.0}) {
        const double part = phong_share(kernel.peak(), exponent, 500, [&](const Vec3& w) {
            return on_ceiling(light, w) && w.x < wall * (w.z / 2500);
        });
        const double share = visible_gloss_share(lobe, test::ShowsBelow(wall), {3e-3, 1, true});
        EXPECT_NEAR(share, part / whole, 4e-3) << wall;
    }
}

} // namespace
} // namespace keiko
