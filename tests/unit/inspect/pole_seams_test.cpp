// Seams that meet at a pole: sectors of one surface, each with a side that is a point.
#include "keiko/inspect/inspection.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

/// The paraboloid 2 z = k r^2 about z up to about r = 50 mm, exactly, in equal sectors that meet at
/// its tip. `digits`: decimals to which the control points are rounded, in mm.
struct Cap {
    int sectors = 3, digits = 15;
    Vec3 tip{0};
    double curvature = 0.02; ///< 1/mm

    SurfaceModel build() const {
        test::ModelBuilder builder;
        for (int i = 0; i < sectors; ++i) builder.patch(2, 4, sector(i));
        return builder.build();
    }

private:
    /// u is radial, v around: (u C(v), k / 2 u^2 |C(v)|^2) with a parabola C.
    std::vector<Vec3> sector(int index) const {
        const double step = 2 * std::numbers::pi / sectors, begin = index * step;
        const auto at = [](double angle, double r) {
            return Vec2(r * std::cos(angle), r * std::sin(angle));
        };
        const std::array c{at(begin, 50), at(begin + step / 2, 50 / std::cos(step / 2)),
                           at(begin + step, 50)};
        constexpr std::array<double, 3> of_two{1, 2, 1};
        constexpr std::array<double, 5> of_four{1, 4, 6, 4, 1};
        std::vector<Vec2> raised(5, Vec2(0));
        std::array<double, 5> squared{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const double share = of_two[i] * of_two[j] / of_four[i + j];
                raised[i + j] += c[i] * share;
                squared[i + j] += c[i].dot(c[j]) * share;
            }
        std::vector<Vec3> points;
        for (const double u : {0.0, 0.5, 1.0})
            for (std::size_t v = 0; v < 5; ++v)
                points.push_back(rounded(tip + Vec3(u * raised[v].x, u * raised[v].y,
                                                    u == 1 ? curvature / 2 * squared[v] : 0)));
        return points;
    }
    Vec3 rounded(const Vec3& p) const {
        const double scale = std::pow(10, digits);
        return {std::round(p.x * scale) / scale, std::round(p.y * scale) / scale,
                std::round(p.z * scale) / scale};
    }
};

TEST(PoleSeams, PassHoweverTheirFileIsRounded) {
    for (const int sectors : {3, 4})
        for (const int digits : {6, 7, 9, 10, 12})
            for (const double x : {0.0, 100.0, 1503.7}) {
                const Inspection found = inspect(
                    Cap{.sectors = sectors, .digits = digits, .tip = {x, -x / 3, x}}.build());
                EXPECT_EQ(found.verdict, Verdict::pass) << sectors << ' ' << digits << ' ' << x;
                EXPECT_EQ(found.seams.size(), static_cast<std::size_t>(sectors));
            }
}

/// The middle of the second row bends the borders of its sector, the more the nearer to the pole:
/// the mismatch is over 10 % where r < 20 mm / mm of `lift`.
Inspection bent_at_the_pole(double lift) {
    SurfaceModel model = Cap{.digits = 9}.build();
    model.control_points[5 + 2].z += lift;
    return inspect(model);
}

TEST(PoleSeams, FailWhereTheirCurvaturesBreakForMoreThanIsNegligible) {
    const Inspection found = bent_at_the_pole(0.05);
    ASSERT_FALSE(found.findings.empty());
    for (const Check& finding : found.findings) {
        EXPECT_EQ(finding.code, "G-SU-NS");
        EXPECT_LT(finding.worst.place.length(), 1.2);
    }
    EXPECT_EQ(bent_at_the_pole(0.002).verdict, Verdict::pass);
}

} // namespace
} // namespace keiko
