#include "keiko/maps/bump.h"

#include "keiko/film/image_file.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/maps/picture_texture.h"
#include "keiko/maps/texture.h"

#include "tests/support/oracle.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::OracleRow;
using test::OracleTable;

/// Height over a surface whose tangents by u and v it rises along by these slopes.
HeightJet slopes_of(const Vec3& pu, const Vec3& pv, double hu, double hv) {
    const Vec3 n = pu.cross(pv);
    HeightJet height;
    height.gradient = (pv.cross(n) * hu + n.cross(pu) * hv) / n.length2();
    return height;
}

SurfaceDerivatives tangents(const Vec3& pu, const Vec3& pv) {
    SurfaceDerivatives s;
    s.d[1][0] = pu, s.d[0][1] = pv;
    return s;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance, const std::string& id) {
    EXPECT_LE((a - b).length(), tolerance) << id;
}

Vec3 normal_with(const SurfaceDerivatives& s, double hu, double hv) {
    const Vec3 n = s.du().cross(s.dv()).normalized();
    const HeightJet height = slopes_of(s.du(), s.dv(), hu, hv);
    const SurfaceDerivatives bent = raised(s, n, height);
    EXPECT_LE(
        (bent.du().cross(bent.dv()).normalized() - raised_normal(n, height.gradient)).length(),
        1e-14);
    return raised_normal(n, height.gradient);
}

TEST(Bump, NormalIsTheOracles) {
    const OracleTable table("bump");
    ASSERT_EQ(table.size(), 5U);
    for (const OracleRow& row : table) {
        const double A = row.number("in.A"), a = row.number("in.a"), b = row.number("in.b");
        const double u = row.number("in.u"), v = row.number("in.v");
        const double hu = A * a * std::cos(a * u) * std::sin(b * v);
        const double hv = A * b * std::sin(a * u) * std::cos(b * v);
        EXPECT_NEAR(hu, row.number("out.hu"), 1e-12) << row.id();
        EXPECT_NEAR(hv, row.number("out.hv"), 1e-12) << row.id();
        const SurfaceDerivatives s = tangents(row.vector("in.Pu"), row.vector("in.Pv"));
        expect_near(normal_with(s, hu, hv), row.vector("out.Np"), 1e-11, row.id());
    }
}

SurfaceDerivatives patch_at(const OracleRow& row) {
    std::vector<Vec4> net;
    for (const Vec3& p : row.points("in.patch")) net.emplace_back(p.x, p.y, p.z, 1);
    return evaluate(BezierPatchView{3, 3, net}, {row.number("in.u"), row.number("in.v")}, 2);
}

/// A sin(2 pi a u) sin(2 pi b v).
struct Waves {
    double A, a, b;

    explicit Waves(const OracleRow& row)
        : A(row.number("in.A")),
          a(2 * std::numbers::pi * row.number("in.a")),
          b(2 * std::numbers::pi * row.number("in.b")) {}

    double at(double u, double v) const { return A * std::sin(a * u) * std::sin(b * v); }
    double by_u(double u, double v) const { return A * a * std::cos(a * u) * std::sin(b * v); }
    double by_v(double u, double v) const { return A * b * std::sin(a * u) * std::cos(b * v); }
};

/// Slopes of the picture of the waves, by Texture::height. Files hold floats, whose rounding
/// over a texel the slopes have.
Vec2 picture_slopes(const Waves& waves, const OracleRow& row) {
    const int w = row.integer("in.Wt"), h = row.integer("in.Ht");
    NamedImage image{Image(w, h, 1), {"Y"}};
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            *image.image.pixel(x, y) = static_cast<float>(waves.at((x + 0.5) / w, (y + 0.5) / h));
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "height.exr";
    std::ofstream(file, std::ios::binary) << encode_exr(image);
    const Texture texture({.kind = TextureKind::picture, .file = file}, false);
    const TextureFrame frame{{Vec3(row.number("in.u"), row.number("in.v"), 0)},
                             {Vec3(1, 0, 0), Vec3(0, 1, 0)},
                             {Vec3(1, 0, 0), Vec3(0, 1, 0)}};
    const Vec3 gradient = texture.height(frame).gradient;
    return {gradient.x, gradient.y};
}

TEST(Bump, NormalsOfAPatchAreTheOracles) {
    const OracleTable table("patch_bump");
    ASSERT_EQ(table.size(), 9U);
    for (const OracleRow& row : table) {
        const SurfaceDerivatives s = patch_at(row);
        const double size = s.position().length();
        expect_near(s.position(), row.vector("out.S"), 1e-11 * size, row.id());
        expect_near(s.du(), row.vector("out.Pu"), 1e-11 * s.du().length(), row.id());
        expect_near(s.dv(), row.vector("out.Pv"), 1e-11 * s.dv().length(), row.id());
        const Vec3 n = s.du().cross(s.dv()).normalized();
        expect_near(n, row.vector("out.N"), 1e-11, row.id());
        const MapTangents frame(s.du(), s.dv(), n);
        const Vec3 texel = row.vector("in.rgb") * 2 - Vec3(1);
        expect_near(mapped_normal({texel.x, texel.y, texel.z}, frame.tangent, frame.bitangent, n),
                    row.vector("out.N_map"), 1e-11, row.id());
        const Waves waves(row);
        const double u = row.number("in.u"), v = row.number("in.v");
        const Vec3 blinn = normal_with(s, waves.by_u(u, v), waves.by_v(u, v));
        expect_near(blinn, row.vector("out.N_blinn"), 1e-11, row.id());
        expect_near(normal_with(s, row.number("out.hu_cd"), row.number("out.hv_cd")),
                    row.vector("out.N_cd"), 1e-10, row.id());
        EXPECT_NEAR(angle_between(blinn, row.vector("out.N_exact")) * 180 / std::numbers::pi,
                    row.number("out.angle_deg"), 1e-8)
            << row.id();
        const Vec2 slopes = picture_slopes(waves, row);
        const double rounding = 1e-7 * waves.A * std::max(row.number("in.Wt"), row.number("in.Ht"));
        EXPECT_NEAR(slopes.x, row.number("out.hu_cd"), rounding) << row.id();
        EXPECT_NEAR(slopes.y, row.number("out.hv_cd"), rounding) << row.id();
    }
}

/// The normal of a raised plane turns as its second derivatives say.
TEST(Bump, SecondDerivativesAreThoseOfTheRaisedSurface) {
    const OrangePeel peel({0, 0, 2, 20, 50}, 4);
    const Vec3 e(1, 0, 0), f(0, 1, 0), n(0, 0, 1);
    const auto surface = [&](const Vec2& at) {
        return raised(tangents(e, f), n, peel.height({Vec3(at.x, at.y, 0)}));
    };
    const Vec2 at(3.7, -1.2);
    constexpr double step = 1e-5;
    const SurfaceDerivatives s = surface(at);
    const SurfaceDerivatives after = surface(at + Vec2(step, 0)),
                             before = surface(at - Vec2(step, 0));
    expect_near(s.d[2][0], (after.d[1][0] - before.d[1][0]) / (2 * step), 1e-7, "uu");
    expect_near(s.d[1][1], (after.d[0][1] - before.d[0][1]) / (2 * step), 1e-7, "uv");
}

} // namespace
} // namespace keiko
