#include "keiko/inspect/overlaps/self_contact.h"

#include "keiko/inspect/inspection.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

constexpr double limit = 0.02; // mm

std::optional<SelfContact> contact_of(const SurfaceModel& model, double least = limit) {
    return self_contact(model, {0, 0}, least);
}

/// A plane curve of Bezier pieces of one degree, drawn out along z by 10 mm; one face.
SurfaceModel drawn_out(int degree, const std::vector<Vec4>& points) {
    const std::size_t pieces = (points.size() - 1) / static_cast<std::size_t>(degree);
    NurbsSurface surface{degree, 1, {}, {0, 0, 1, 1}, {}};
    surface.knots_u.push_back(0);
    for (std::size_t k = 0; k <= pieces; ++k)
        for (int i = 0; i < degree; ++i) surface.knots_u.push_back(static_cast<double>(k));
    surface.knots_u.push_back(static_cast<double>(pieces));
    for (const Vec4& p : points) {
        surface.points.push_back(p);
        surface.points.emplace_back(p.x, p.y, p.z + 10 * p.w, p.w);
    }
    test::ModelBuilder builder;
    builder.nurbs(surface);
    return builder.build();
}

/// A cubic that crosses itself on x = 10, and is symmetric about that line.
std::vector<Vec4> looping_cubic() {
    return {{0, 0, 0, 1}, {50, 30, 0, 1}, {-30, 30, 0, 1}, {20, 0, 0, 1}};
}

/// Two legs of 20 mm, `gap` apart, joined by half a circle.
SurfaceModel hairpin(double gap) {
    const double r = gap / 2, w = std::sqrt(0.5);
    std::vector<Vec4> points{{0, 0, 0, 1}, {10, 0, 0, 1}, {20, 0, 0, 1}};
    points.emplace_back((20 + r) * w, 0, 0, w);
    points.emplace_back(20 + r, r, 0, 1);
    points.emplace_back((20 + r) * w, gap * w, 0, w);
    for (const double x : {20.0, 10.0, 0.0}) points.emplace_back(x, gap, 0, 1);
    return drawn_out(2, points);
}

TEST(SelfContact, LeavesFacesAloneThatKeepClear) {
    EXPECT_FALSE(contact_of(test::bonnet_model(1200, 900, 60)));
    EXPECT_FALSE(contact_of(hairpin(5)));
    EXPECT_FALSE(
        contact_of(drawn_out(3, {{0, 0, 0, 1}, {5, 9, 0, 1}, {15, 9, 0, 1}, {20, 0, 0, 1}})));
}

/// Closed in one or in both parameters, and with poles.
TEST(SelfContact, LeavesClosedFacesAlone) {
    EXPECT_FALSE(
        contact_of(test::cylinder_model(test::stretched({50, 50, 80}, {0, 0, 1}, Vec3(0)))));
    EXPECT_FALSE(contact_of(test::sphere_model(test::stretched(Vec3(100), {0, 0, 1}, Vec3(0)))));
    EXPECT_FALSE(contact_of(test::torus_model(80, 20)));
}

/// A tube wider than its ring meets itself in two singular points of the axis alone.
TEST(SelfContact, DoesNotDecideOnATorusWhoseTubeIsTooWide) {
    EXPECT_TRUE(self_contact(test::torus_model(20, 30), {0, 0}, limit, 4000));
}

TEST(SelfContact, FindsTheLineOnWhichALoopedSheetCrossesItself) {
    const auto contact = contact_of(drawn_out(3, looping_cubic()));
    ASSERT_TRUE(contact && contact->found);
    EXPECT_LT(contact->distance, limit / 10);
    EXPECT_NEAR(contact->place.x, 10, limit / 10);
    EXPECT_GT(contact->angle, 10);
    EXPECT_GT(contact->way, 10);
}

TEST(SelfContact, TellsAHairpinBelowTheLimitFromOneAbove) {
    const auto contact = contact_of(hairpin(0.019));
    ASSERT_TRUE(contact && contact->found);
    EXPECT_NEAR(contact->distance, 0.019, 1e-6);
    EXPECT_GT(contact->way, neighbour_factor * limit);
    EXPECT_FALSE(contact_of(hairpin(0.021)));
}

TEST(SelfContact, DoesNotCountWhatTrimsRemove) {
    SurfaceModel model = drawn_out(3, looping_cubic());
    const auto trimmed = [&](double end) {
        test::ModelBuilder builder;
        std::vector<Vec3> points;
        for (const Vec4& p : model.control_points) points.emplace_back(p.x, p.y, p.z);
        builder.patch(3, 1, points);
        builder.polygon({Vec2(0), Vec2(end, 0), Vec2(end, 1), Vec2(0, 1)});
        return builder.build();
    };
    EXPECT_FALSE(contact_of(trimmed(0.6)));
    EXPECT_TRUE(contact_of(trimmed(0.99)));
}

/// The loop of the cubic alone: its ends meet, as the borders of a seam do.
TEST(SelfContact, LeavesBordersAloneThatMeet) {
    // x(t) = 10 at t = 1/2 and where 230 (t - 1/2)^2 is as at the crossing: bisect for it.
    const auto x = [](double t) {
        const double s = 1 - t;
        return 3 * s * s * t * 50 - 3 * s * t * t * 30 + t * t * t * 20;
    };
    double low = 0.001, high = 0.3;
    for (int k = 0; k < 60; ++k) (x((low + high) / 2) < 10 ? low : high) = (low + high) / 2;
    const SurfaceModel whole = drawn_out(3, looping_cubic());
    test::ModelBuilder builder;
    std::vector<Vec3> points;
    for (const Vec4& p : whole.control_points) points.emplace_back(p.x, p.y, p.z);
    builder.patch(3, 1, points);
    builder.polygon({Vec2(low, 0), Vec2(1 - low, 0), Vec2(1 - low, 1), Vec2(low, 1)});
    const auto contact = contact_of(builder.build());
    EXPECT_FALSE(contact && contact->found);
}

TEST(SelfContact, IsUndecidedWithoutWork) {
    const auto contact = self_contact(drawn_out(3, looping_cubic()), {0, 0}, limit, 3);
    ASSERT_TRUE(contact);
    EXPECT_FALSE(contact->found);
}

TEST(SelfContact, IsAFindingWithItsNames) {
    CriteriaPreset preset;
    preset.structure.self_distance = limit;
    const Inspection inspection = inspect(drawn_out(3, looping_cubic()), preset);
    const auto found = std::find_if(inspection.findings.begin(), inspection.findings.end(),
                                    [](const Check& check) { return check.code == "G-SU-IS"; });
    ASSERT_NE(found, inspection.findings.end());
    EXPECT_EQ(found->rule, "self_intersecting_surface");
    EXPECT_EQ(found->worst.verdict, Verdict::fail);
    EXPECT_NE(found->message.find("under the limit of 0.02 mm; its sides meet at"),
              std::string::npos)
        << found->message;
    EXPECT_EQ(inspection.faces[0].verdict, Verdict::fail);
}

/// True if the segment pq passes through the triangle abc, by more than rounding.
bool passes(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto volume = [](const Vec3& o, const Vec3& x, const Vec3& y, const Vec3& z) {
        return (x - o).cross(y - o).dot(z - o);
    };
    const double above = volume(p, a, b, c), below = volume(q, a, b, c);
    if (!(above * below < 0)) return false;
    const double i = volume(p, q, a, b), j = volume(p, q, b, c), k = volume(p, q, c, a);
    return (i > 0 && j > 0 && k > 0) || (i < 0 && j < 0 && k < 0);
}

/// True if edges of a mesh of n x n cells pass through its triangles at least three cells away.
bool mesh_crosses_itself(const BezierPatchView& patch, int n) {
    const auto at = [n](int i, int j) { return static_cast<std::size_t>(i * (n + 1) + j); };
    std::vector<Vec3> points;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            points.push_back(evaluate(patch, Vec2(double(i) / n, double(j) / n), 0).position());
    constexpr int apart = 3;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k)
                for (int l = 0; l < n; ++l) {
                    if (std::max(std::abs(i - k), std::abs(j - l)) < apart) continue;
                    const Vec3 &p = points[at(i, j)], &q = points[at(i + 1, j)],
                               &r = points[at(i, j + 1)];
                    const Vec3 &a = points[at(k, l)], &b = points[at(k + 1, l)],
                               &c = points[at(k, l + 1)], &d = points[at(k + 1, l + 1)];
                    if (passes(p, q, a, b, c) || passes(p, q, b, d, c) || passes(p, r, a, b, c) ||
                        passes(p, r, b, d, c))
                        return true;
                }
    return false;
}

/// A bicubic of 100 mm whose control points are anywhere within `mess` mm of even ones.
SurfaceModel messy_patch(test::Random& random, double mess) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j)
            points.push_back(Vec3(i * 33, j * 33, 0) +
                             test::random_direction(random) * test::uniform(random, 0, mess));
    test::ModelBuilder builder;
    builder.patch(3, 3, points);
    return builder.build();
}

/// Two meshes, of different sizes, that cross themselves are proof that the patch does. A patch
/// that is said to be clear has no such meshes.
TEST(SelfContact, AgreesWithMeshesOfRandomPatches) {
    test::Random random(37);
    int crossing = 0, clear = 0, undecided = 0;
    for (int k = 0; k < 60; ++k) {
        const SurfaceModel model = messy_patch(random, k % 2 ? 150 : 25);
        const auto contact = contact_of(model);
        const BezierPatchView patch = model.patch(0);
        const bool crosses = mesh_crosses_itself(patch, 16) && mesh_crosses_itself(patch, 25);
        if (crosses) {
            EXPECT_TRUE(contact) << k;
        }
        if (contact && !contact->found) ++undecided;
        if (contact && contact->found) {
            EXPECT_LE(contact->distance, limit) << k;
        }
        crossing += crosses;
        clear += !contact;
    }
    EXPECT_GT(crossing, 10);
    EXPECT_GT(clear, 20);
    EXPECT_LE(undecided, 12);
}

/// Two legs that a straight way apart approach each other to a planted distance.
TEST(SelfContact, FindsPlantedDistances) {
    test::Random random(38);
    for (int k = 0; k < 20; ++k) {
        const double gap =
            limit * (k % 2 ? test::uniform(random, 0.1, 0.97) : test::uniform(random, 1.03, 3));
        SurfaceModel model = hairpin(gap);
        model.instances[0].transform = test::stretched(Vec3(1), test::random_direction(random),
                                                       test::random_direction(random) * 1000);
        const auto contact = contact_of(model);
        EXPECT_EQ(contact.has_value(), gap < limit) << gap;
        if (contact && contact->found) {
            EXPECT_NEAR(contact->distance, gap, 1e-6) << gap;
        }
    }
}

} // namespace
} // namespace keiko
