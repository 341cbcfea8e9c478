#include "keiko/maps/environment.h"

#include "keiko/base/error.h"
#include "keiko/film/image_file.h"
#include "keiko/maps/panorama.h"

#include "tests/support/oracle.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

namespace keiko {
namespace {

using test::OracleRow;
using test::OracleTable;
constexpr double pi = std::numbers::pi;

/// Bilinear value of a picture of doubles: pictures hold floats, so what these leave over is a
/// second picture.
double bilinear(int width, int height, const std::function<double(int, int)>& value,
                const Vec2& at) {
    constexpr double shift = 16777216;
    Image rounded(width, height, 1), rest(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float near = static_cast<float>(value(x, y));
            *rounded.pixel(x, y) = near;
            *rest.pixel(x, y) =
                static_cast<float>((value(x, y) - static_cast<double>(near)) * shift);
        }
    const TexturePlace place{Vec3(at.x, at.y, 0)};
    return PictureTexture(rounded, Wrap::repeat, Wrap::clamp).value(place).g +
           PictureTexture(rest, Wrap::repeat, Wrap::clamp).value(place).g / shift;
}

TEST(Panorama, PlacesOfDirectionsAreTheOracles) {
    const OracleTable table("env_lookup");
    ASSERT_EQ(table.size(), 14U);
    constexpr double tolerance = 1e-12;
    for (const OracleRow& row : table) {
        const Vec3 direction = row.unit("in.dir");
        const int width = row.integer("in.W"), height = row.integer("in.H");
        const Vec2 at = lat_long_place(direction).at;
        EXPECT_NEAR(at.x, row.number("out.u"), tolerance) << row.id();
        EXPECT_NEAR(at.y, row.number("out.v"), tolerance) << row.id();
        EXPECT_EQ(std::floor(at.x * width), row.number("out.col")) << row.id();
        const int line = std::min(static_cast<int>(at.y * height), height - 1);
        EXPECT_EQ(line, row.integer("out.row")) << row.id();
        const CubePlace cube = cube_place(direction);
        EXPECT_EQ(cube.face, static_cast<std::size_t>(row.integer("out.face"))) << row.id();
        EXPECT_NEAR(cube.at.at.x, row.number("out.s"), tolerance) << row.id();
        EXPECT_NEAR(cube.at.at.y, row.number("out.t"), tolerance) << row.id();
        EXPECT_NEAR(lat_long_solid_angle(width, height, line), row.number("out.texel_omega"),
                    tolerance);
        EXPECT_NEAR(cube_solid_angle(cube.at.at), row.number("out.face_jac"), tolerance);
        const double ka = row.number("in.ka"), kb = row.number("in.kb");
        const auto value = [&](int x, int y) {
            return 1 + 0.5 * std::sin(2 * pi * ka * (x + 0.5) / width) *
                           std::cos(pi * kb * (y + 0.5) / height);
        };
        EXPECT_NEAR(bilinear(width, height, value, at), row.number("out.bilinear"), tolerance)
            << row.id();
    }
}

TEST(Panorama, DirectionsAndPlacesAreInverse) {
    for (const Vec3& w : {Vec3(0.3, -0.2, 0.9), Vec3(-0.8, 0.5, -0.1), Vec3(0.1, 0.9, 0.3)}) {
        const Vec3 unit = w.normalized();
        EXPECT_LT((lat_long_direction(lat_long_place(w).at) - unit).length(), 1e-14);
        const CubePlace cube = cube_place(w);
        EXPECT_LT((cube_direction(cube.face, cube.at.at) - unit).length(), 1e-14);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 step(0);
            step[axis] = 1e-5;
            const Vec2 change = cube_place(w + step).at.at - cube_place(w - step).at.at;
            EXPECT_NEAR(cube.at.grad_u[axis], change.x / 2e-5, 1e-8);
            EXPECT_NEAR(cube.at.grad_v[axis], change.y / 2e-5, 1e-8);
        }
    }
}

/// A panorama of luminances in a file.
class PictureFile {
public:
    PictureFile(int width, int height, const std::function<double(const Vec2&)>& luminance) {
        NamedImage image{Image(width, height, 1), {"Y"}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                *image.image.pixel(x, y) =
                    static_cast<float>(luminance(Vec2((x + 0.5) / width, (y + 0.5) / height)));
        std::ofstream(path(), std::ios::binary) << encode_exr(image);
    }
    std::filesystem::path path() const { return folder_.path() / "panorama.exr"; }

private:
    test::TemporaryFolder folder_;
};

struct Quadratic {
    double L0;
    Vec3 g;
    std::vector<double> Q; ///< xx, yy, zz, xy, xz, yz

    explicit Quadratic(const OracleRow& row)
        : L0(row.number("in.L0")), g(row.vector("in.g")), Q(row.list("in.Q")) {}

    double at(const Vec3& w) const {
        return L0 * (1 + g.dot(w) + Q[0] * w.x * w.x + Q[1] * w.y * w.y + Q[2] * w.z * w.z +
                     2 * (Q[3] * w.x * w.y + Q[4] * w.x * w.z + Q[5] * w.y * w.z));
    }
};

/// The low orders of light that is a polynomial of the second degree, by a rule that is exact for
/// those of the fourth: Gauss's in z, equal steps about it.
LowOrderLight low_orders(const Quadratic& light) {
    const double z[] = {0, std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3,
                        std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3};
    const double weights[] = {128.0 / 225, (322 + 13 * std::sqrt(70.0)) / 900,
                              (322 - 13 * std::sqrt(70.0)) / 900};
    constexpr int steps = 7;
    LowOrderLight sum;
    for (int i = -2; i <= 2; ++i)
        for (int k = 0; k < steps; ++k) {
            const double cosine = i < 0 ? -z[-i] : z[i], phi = 2 * pi * k / steps;
            const double sine = std::sqrt(1 - cosine * cosine);
            const Vec3 w(sine * std::cos(phi), sine * std::sin(phi), cosine);
            sum.add(w, Rgb(light.at(w)), weights[std::abs(i)] * 2 * pi / steps);
        }
    return sum;
}

TEST(Environment, IrradianceIsTheOracles) {
    const OracleTable table("env_irradiance");
    ASSERT_EQ(table.size(), 9U);
    int lobes = 0;
    for (const OracleRow& row : table) {
        const Vec3 normal = row.unit("in.N");
        const double expected = row.number("out.E");
        if (row.text("in.kind") == "quadratic") {
            const Quadratic light(row);
            EXPECT_NEAR(low_orders(light).irradiance(normal).g, expected, 1e-12 * expected);
            const PictureFile file(
                256, 128, [&](const Vec2& at) { return light.at(lat_long_direction(at)); });
            const Environment panorama({.file = file.path()});
            EXPECT_NEAR(panorama.irradiance(normal).g, expected, 1e-4 * expected) << row.id();
            continue;
        }
        ++lobes;
        const Vec3 c = row.unit("in.c");
        const auto luminance = [&](const Vec3& w) {
            return row.number("in.L0") * std::exp(row.number("in.kap") * (w.dot(c) - 1));
        };
        const PictureFile file(256, 128,
                               [&](const Vec2& at) { return luminance(lat_long_direction(at)); });
        const Environment panorama({.file = file.path()});
        EXPECT_NEAR(panorama.texel_irradiance(normal).g, expected, 1e-4 * expected) << row.id();
        const PictureFile squares(768, 128, [&](const Vec2& at) {
            const auto face = static_cast<std::size_t>(at.x * 6);
            return luminance(cube_direction(face, {at.x * 6 - static_cast<double>(face), at.y}));
        });
        const Environment cube({.file = squares.path(), .layout = EnvironmentSpec::Layout::cube});
        EXPECT_NEAR(cube.texel_irradiance(normal).g, expected, 1e-4 * expected) << row.id();
        const double off = panorama.irradiance(normal).g - expected;
        double most = 0; // of 26 normals, so about that of any
        for (const Vec3& n : {c, normal}) most = std::max(most, panorama.texel_irradiance(n).g);
        EXPECT_LE(std::abs(off), 1.5 * panorama.low_order_error() * most) << row.id();
    }
    EXPECT_GT(lobes, 0);
}

/// A column of +x, turned to +y.
TEST(Environment, AzimuthTurnsItAnticlockwise) {
    const PictureFile file(8, 4, [](const Vec2& at) { return at.x < 0.125 ? 1.0 : 0.0; });
    const Environment plain({.file = file.path(), .luminance = Rgb(5)});
    const Environment turned({.file = file.path(), .luminance = Rgb(5), .azimuth = 90});
    const Vec3 lit = lat_long_direction({0.0625, 0.5}), after(-lit.y, lit.x, lit.z);
    EXPECT_NEAR(plain.luminance(lit).g, 5, 1e-6);
    EXPECT_NEAR(turned.luminance(after).g, 5, 1e-6);
    EXPECT_NEAR(turned.luminance(lit).g, 0, 1e-6);
    EXPECT_NEAR(turned.irradiance(after).g, plain.irradiance(lit).g, 1e-12);
}

TEST(Environment, UniformLightIsUniform) {
    const PictureFile file(128, 64, [](const Vec2&) { return 2.0; });
    const Environment sky({.file = file.path()});
    for (const Vec3& w : {Vec3(0, 0, 1), Vec3(0.6, 0, -0.8), Vec3(-1, 0, 0)}) {
        EXPECT_NEAR(sky.irradiance(w).g, 2 * pi, 1e-2);
        EXPECT_DOUBLE_EQ(sky.luminance(w, Vec3(0.3, 0, 0), Vec3(0, 0.2, 0.1)).g, 2);
        EXPECT_DOUBLE_EQ(sky.blurred(w, 1).g, 2);
    }
    EXPECT_LT(sky.low_order_error(), 5e-3);
}

/// A ceiling that fills the square of directions has its own luminance in the mean, wherever the
/// square lies about the zenith, in which all columns of a panorama meet.
TEST(Environment, BlurKnowsNoPoles) {
    const PictureFile file(256, 128, [](const Vec2& at) { return at.y < 1.0 / 3 ? 1.0 : 0.0; });
    const Environment ceiling({.file = file.path()});
    for (const double degrees : {0.0, 0.1, 1.0, 5.0, 8.0, 15.0, 30.0})
        for (const double turn : {0.0, 0.7, 2.0, 4.0}) {
            const double theta = degrees * pi / 180;
            const Vec3 w(std::sin(theta) * std::cos(turn), std::sin(theta) * std::sin(turn),
                         std::cos(theta));
            for (const double width : {0.05, 0.2, 0.4})
                EXPECT_NEAR(ceiling.blurred(w, width).g, 1, 0.05) << degrees << " " << turn;
        }
    EXPECT_NEAR(ceiling.blurred(Vec3(std::sin(pi / 3), 0, std::cos(pi / 3)), 0.2).g, 0.5, 0.1);
}

/// A pixel of the picture is as high beside a pole as elsewhere, wide as it is there: a step eight
/// rows below the pole is not seen at it.
TEST(Environment, PixelsBesideThePoleAreAsHighAsElsewhere) {
    const PictureFile file(512, 256, [](const Vec2& at) { return at.y < 8.0 / 256 ? 1.0 : 9.0; });
    const Environment ceiling({.file = file.path()});
    const double texel = pi / 256;
    for (const double rows : {0.01, 0.1, 0.5, 2.0, 5.0}) {
        const Vec3 w(std::sin(rows * texel), 0, std::cos(rows * texel));
        for (const double turned : {0.0, 0.7}) {
            const Vec3 x(texel * std::cos(turned), texel * std::sin(turned), 0);
            EXPECT_NEAR(ceiling.luminance(w, x, Vec3(-x.y, x.x, 0)).g, 1, 1e-9) << rows;
        }
    }
}

TEST(Environment, RefusesACubeThatIsNotSaidToBeOne) {
    const PictureFile file(96, 16, [](const Vec2&) { return 2.0; });
    EXPECT_THROW(Environment({.file = file.path()}), Error);
    EXPECT_NO_THROW(Environment({.file = file.path(), .layout = EnvironmentSpec::Layout::cube}));
}

/// Blocks of texels stand for those of pictures that are larger than need be.
TEST(Environment, LargePicturesLightAsSmallOnes) {
    const auto luminance = [](const Vec2& at) {
        const Vec3 w = lat_long_direction(at);
        return 2 + w.x + w.y * w.z;
    };
    const PictureFile large(1100, 550, luminance), small(275, 138, luminance);
    const Environment a({.file = large.path()}), b({.file = small.path()});
    for (const Vec3& n : {Vec3(1, 0, 0), Vec3(0, 0.6, 0.8), Vec3(0, 0, -1)})
        EXPECT_NEAR(a.irradiance(n).g, b.irradiance(n).g, 1e-4 * b.irradiance(n).g);
}

TEST(Environment, RefusesPicturesThatAreNoCube) {
    const PictureFile file(32, 16, [](const Vec2&) { return 2.0; });
    EXPECT_THROW(Environment({.file = file.path(), .layout = EnvironmentSpec::Layout::cube}),
                 Error);
}

} // namespace
} // namespace keiko
