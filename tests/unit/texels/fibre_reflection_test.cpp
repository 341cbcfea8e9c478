#include "keiko/texels/fibre_reflection.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

/// Integral of N.L / 2 over the lit half of a cylinder along a fibre, by the midpoint rule.
double lit_half(const Vec3& fibre, const Vec3& to_light) {
    const Vec3 up = (to_light - fibre * fibre.dot(to_light)).normalized();
    const Vec3 aside = fibre.cross(up);
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double angle = pi * ((i + 0.5) / steps - 0.5);
        sum += (up * std::cos(angle) + aside * std::sin(angle)).dot(to_light);
    }
    return sum * pi / steps / 2;
}

TEST(FibreReflection, AgreesWithOracle) {
    const test::OracleTable table("kajiya_kay");
    test::WorstError diffuse("diff"), integral("diff_bf"), cosine("cosEE"), specular("spec");
    for (const auto& row : table) {
        const Vec3 fibre = row.unit("in.Tg"), light = row.unit("in.Lt"), eye = row.unit("in.Ev");
        diffuse.compare(row, fibre_diffuse(fibre, light), row.number("out.diff"), 1e-12);
        integral.compare(row, lit_half(fibre, light), row.number("out.diff_bf"), 1e-8);
        const double cone = fibre_cone_cosine(fibre, light, eye);
        cosine.compare(row, cone, row.number("out.cosEE"), 1e-12);
        specular.compare(row, fibre_specular(cone, row.number("in.p")), row.number("out.spec"),
                         1e-11);
    }
}

/// Light that a length of a fibre of the width 1 sends to all sides, per lx across the light, which
/// comes from across the fibre.
template <class Luminance>
double sent(const Luminance& luminance) {
    const Vec3 fibre(0, 0, 1), light(1, 0, 0);
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double z = std::cos(pi * (i + 0.5) / steps), wide = std::sqrt(1 - z * z);
        sum += luminance(fibre, light, Vec3(wide, 0, z)) * wide * 2 * pi * wide * pi / steps;
    }
    return sum;
}

TEST(FibreReflection, SendsItsShareOfTheLightThatArrives) {
    EXPECT_NEAR(sent([](const Vec3& fibre, const Vec3& light, const Vec3&) {
                    return fibre_diffuse(fibre, light) * fibre_diffuse_scale();
                }),
                1, 1e-6);
    for (const double exponent : {1.0, 7.5, 60.0})
        EXPECT_NEAR(sent([&](const Vec3& fibre, const Vec3& light, const Vec3& eye) {
                        return fibre_specular(fibre_cone_cosine(fibre, light, eye), exponent) *
                               fibre_highlight_scale(exponent);
                    }),
                    1, 1e-6)
            << exponent;
}

} // namespace
} // namespace keiko
