#include "keiko/light/fog/transmittance.h"
#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/rig/surface_light.h"
#include "keiko/light/spotlight/spotlight.h"
#include "keiko/light/tubes/tube_irradiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace keiko;

namespace {

const CPlane row{.origin = {-600, -500, 2000},
                 .u = {1200, 0, 0},
                 .v = {0, 1000, 0},
                 .lamps = 4,
                 .luminance = {9000, 8000, 7000}};
const Spotlight spot{.position = {0, 0, 3000}, .aim = Vec3(0), .intensity = Rgb(5000)};
const Vec3 up(0, 0, 1);
constexpr double pi = std::numbers::pi;

/// Something is in the way of everything.
class AllHidden final : public Visibility {
public:
    using Visibility::intervals;
    IntervalSet intervals(const Segment&) const override { return {}; }
};

/// Hides the half of every segment that is nearer to its end a; counts the questions.
class HalfHidden final : public Visibility {
public:
    using Visibility::intervals;
    IntervalSet intervals(const Segment& segment) const override {
        ++asked;
        return segment.a == segment.b ? IntervalSet() : IntervalSet::whole(0.5, 1);
    }
    mutable int asked = 0;
};

struct Sphere {
    Vec3 center{0};
    double radius = 0;

    bool hides(const Vec3& from, const Vec3& to) const {
        const Vec3 way = to - from;
        const double t = std::clamp((center - from).dot(way) / way.length2(), 0.0, 1.0);
        return (from + way * t - center).length() < radius;
    }
};

/// Visibility past a sphere (docs/theory/visibility.md#shadows-in-closed-form).
class PastSphere final : public Visibility {
public:
    using Visibility::intervals;
    PastSphere(const Vec3& viewpoint, const Sphere& sphere)
        : viewpoint_(viewpoint), sphere_(sphere) {}
    IntervalSet intervals(const Segment& segment) const override {
        const Vec3 c = sphere_.center - viewpoint_, v = segment.a - viewpoint_,
                   w = segment.b - segment.a;
        const double k = c.length2() - sphere_.radius * sphere_.radius;
        const double q2 = std::pow(w.dot(c), 2) - w.length2() * k;
        const double q1 = v.dot(c) * w.dot(c) - v.dot(w) * k;
        const double q0 = std::pow(v.dot(c), 2) - v.length2() * k;
        const double disc = q1 * q1 - q2 * q0;
        if (disc <= 0) return IntervalSet::whole();
        const double s = std::sqrt(disc), t0 = (-q1 - s) / q2, t1 = (-q1 + s) / q2;
        return IntervalSet({{std::min(t0, t1), std::max(t0, t1)}}).complement();
    }

private:
    Vec3 viewpoint_;
    Sphere sphere_;
};

bool tube_hides(const TubeLamp& lamp, const Vec3& from, const Vec3& to) {
    const Vec3 axis = (lamp.b - lamp.a).normalized(), way = to - from, at = from - lamp.a;
    const Vec3 d = way - axis * axis.dot(way), o = at - axis * axis.dot(at);
    const double a = d.length2(), b = o.dot(d), c = o.length2() - std::pow(lamp.diameter / 2, 2);
    const double disc = b * b - a * c;
    if (!(disc > 0)) return false;
    const double t = (-b - std::sqrt(disc)) / a, along = axis.dot(at + way * t);
    return t > 0 && t < 1 && along > 0 && along < (lamp.b - lamp.a).length();
}

/// Brute force: the tubes' near sides in small facets, each tested against the sphere and the other
/// tubes, through the medium.
double facets(const CPlane& plane, const Medium& medium, const Vec3& point, const Vec3& normal,
              const Sphere& sphere) {
    constexpr int around = 360, along = 720;
    double sum = 0;
    const std::vector<TubeLamp> lamps = lamps_of(plane);
    for (const TubeLamp& lamp : lamps) {
        const Vec3 axis = (lamp.b - lamp.a).normalized(), at = point - lamp.a;
        const Vec3 towards = (at - axis * axis.dot(at)).normalized();
        const Vec3 sideways = axis.cross(towards);
        const double area = lamp.diameter / 2 * (lamp.b - lamp.a).length() * pi / (around * along);
        for (int i = 0; i < around; ++i) {
            const double phi = pi * ((i + 0.5) / around - 0.5);
            const Vec3 out = towards * std::cos(phi) + sideways * std::sin(phi);
            for (int j = 0; j < along; ++j) {
                const Vec3 x =
                    lamp.a + (lamp.b - lamp.a) * ((j + 0.5) / along) + out * (lamp.diameter / 2);
                const Vec3 way = x - point;
                const double lit = std::max(0.0, normal.dot(way)) * std::max(0.0, -out.dot(way));
                if (!(lit > 0) || sphere.hides(point, x)) continue;
                if (std::any_of(lamps.begin(), lamps.end(), [&](const TubeLamp& other) {
                        return &other != &lamp && tube_hides(other, point, x);
                    }))
                    continue;
                sum += lit / std::pow(way.length2(), 2) * area * plane.luminance.g *
                       transmittance(medium, {x, point}).g;
            }
        }
    }
    return sum;
}

LightRig rig_of(std::vector<LightSource> sources, std::optional<Medium> medium = {}) {
    return {.name = "",
            .sources = std::move(sources),
            .ambient = Rgb(100),
            .medium = std::move(medium)};
}

} // namespace

TEST(DirectIlluminance, SumsOverAllSourcesWithoutTheAmbientLight) {
    const LightRig rig = rig_of({row, spot});
    const auto parts = illuminance_by_source(rig, Vec3(0), up, Unoccluded());
    ASSERT_EQ(parts.size(), 2u);
    Rgb lamps;
    for (const TubeLamp& lamp : lamps_of(row)) lamps += irradiance(lamp, Vec3(0), up);
    EXPECT_NEAR(parts[0].r, lamps.r, 1e-12 * lamps.r);
    EXPECT_NEAR(parts[0].b, lamps.b, 1e-12 * lamps.b);
    EXPECT_NEAR(parts[1].g, 5000 / 9.0, 1e-10);
    EXPECT_EQ(direct_illuminance(rig, Vec3(0), up, Unoccluded()), parts[0] + parts[1]);
}

TEST(DirectIlluminance, CountsWhatIsSeenOnly) {
    const LightRig rig = rig_of({row, spot});
    const auto open = illuminance_by_source(rig, Vec3(0), up, Unoccluded());
    const auto half = illuminance_by_source(rig, Vec3(0), up, HalfHidden());
    EXPECT_NEAR(half[0].r, open[0].r / 2, 1e-10 * open[0].r) << "by symmetry";
    EXPECT_EQ(half[1], Rgb());
}

TEST(DirectIlluminance, DoesNotAskForWhatCannotReachThePoint) {
    const HalfHidden visible;
    const LightRig rig = rig_of({row, spot});
    EXPECT_EQ(direct_illuminance(rig, Vec3(0), -up, visible), Rgb());
    EXPECT_EQ(visible.asked, 0);
    direct_illuminance(rig, Vec3(2500, 0, 0), up, visible); // outside the beam
    // Sub-axes of the width, its halves and quarters, whose ends are known.
    constexpr int lamps = 4, sub_axes = 3 + 2 * 1 + 4 * 7;
    EXPECT_EQ(visible.asked, lamps * sub_axes);
}

TEST(DirectIlluminance, IsAttenuatedOnItsWay) {
    const Medium medium{.extinction = {0, 0.1, 0.5}};
    const auto clear = illuminance_by_source(rig_of({row, spot}), Vec3(0), up, Unoccluded());
    const auto foggy =
        illuminance_by_source(rig_of({row, spot}, medium), Vec3(0), up, Unoccluded());
    EXPECT_NEAR(foggy[1].b, clear[1].b * std::exp(-1.5), 1e-10);
    EXPECT_NEAR(foggy[0].r, clear[0].r, 1e-9 * clear[0].r) << "the pieces make the whole";
    // Lamps are 2 m and more away, those that count little more.
    EXPECT_LT(foggy[0].b, clear[0].b * std::exp(-1.0));
    EXPECT_GT(foggy[0].b, clear[0].b * std::exp(-1.15));
}

TEST(DirectIlluminance, PiecesInFogAreFineEnough) {
    CPlane single = row;
    single.lamps = 1;
    const Medium medium{.extinction = Rgb(1)};
    const double fine = facets(single, medium, Vec3(0), up, Sphere());
    EXPECT_NEAR(illuminance_from(single, medium, Vec3(0), up, Unoccluded()).g, fine, 2e-4 * fine);
}

TEST(DirectIlluminance, WeighsPenumbraeOverTheWidthInFog) {
    CPlane thick = row;
    thick.diameter = 120;
    const Medium medium{.extinction = Rgb(0.4)};
    for (const double beside : {-350.0, -120.0, 60.0, 240.0}) {
        const Sphere sphere{Vec3(beside, 80, 1000), 170};
        const double true_lx = facets(thick, medium, Vec3(0), up, sphere);
        const double lx =
            illuminance_from(thick, medium, Vec3(0), up, PastSphere(Vec3(0), sphere)).g;
        EXPECT_NEAR(lx, true_lx, 1e-3 * true_lx) << beside;
    }
}

TEST(DirectIlluminance, WeighsPenumbraeOverTheWidthWhereTubesHideEachOther) {
    CPlane thick = row;
    thick.diameter = 200;
    const Vec3 point(100, -2500, 1600), normal = Vec3(0, 1, 0.2).normalized();
    for (const double height : {1650.0, 1720.0, 1800.0}) {
        const Sphere sphere{Vec3(0, -1500, height), 140};
        const double true_lx = facets(thick, {}, point, normal, sphere);
        const double lx = illuminance_from(thick, {}, point, normal, PastSphere(point, sphere)).g;
        EXPECT_NEAR(lx, true_lx, 1e-3 * true_lx) << height;
    }
}

TEST(DirectIlluminance, ARowThatNamesItsModelKeepsIt) {
    CPlane near = row;
    near.origin.z = 200;
    const auto lux = [&](TubeModel own, TubeModel asked) {
        near.diffuse = own;
        return illuminance_from(near, {}, Vec3(0), up, Unoccluded(), asked).g;
    };
    const double nishita = lux(TubeModel::automatic, TubeModel::nishita);
    EXPECT_EQ(lux(TubeModel::nishita, TubeModel::automatic), nishita);
    EXPECT_NE(lux(TubeModel::automatic, TubeModel::automatic), nishita);
}

TEST(DirectIlluminance, TheSunIsParallelAndMayBeHidden) {
    const Sun sun{.direction = {0, 3, -4}, .illuminance = {50000, 40000, 30000}};
    const auto lux = [&](const Vec3& normal, const Visibility& visible) {
        return illuminance_from(sun, Medium{.extinction = Rgb(5)}, Vec3(7, 8, 9), normal, visible);
    };
    EXPECT_NEAR(lux(up, Unoccluded()).r, 40000, 1e-9);
    EXPECT_NEAR(lux(Vec3(0, -1, 0), Unoccluded()).b, 18000, 1e-9);
    EXPECT_EQ(lux(-up, Unoccluded()), Rgb());
    EXPECT_EQ(lux(up, HalfHidden()), Rgb());
}

TEST(DirectIlluminance, CountsWhatEntersACoat) {
    // A lamp as long as the eye can see, its light weighted piece by piece.
    const ClearCoat coat(Rgb(0.5), 1.5);
    CPlane single = row;
    single.lamps = 1;
    const TubeLamp lamp = lamps_of(single)[0];
    double entered = 0;
    constexpr int pieces = 2000;
    const Vec3 normal = Vec3(0.9, 0.1, 0.3).normalized();
    for (int i = 0; i < pieces; ++i) {
        const double begin = i / static_cast<double>(pieces);
        const double end = i + 1 == pieces ? 1 : (i + 1.0) / pieces;
        const Vec3 to = lamp.a + (lamp.b - lamp.a) * ((begin + end) / 2);
        entered += irradiance(lamp, Vec3(0), normal, IntervalSet::whole(begin, end)).g *
                   coat.entering(std::max(0.0, normal.dot(to.normalized())));
    }
    const double lit =
        illuminance_from(single, {}, Vec3(0), normal, Unoccluded(), TubeModel::automatic, &coat).g;
    const double all = illuminance_from(single, {}, Vec3(0), normal, Unoccluded()).g;
    EXPECT_NEAR(lit, entered, 2e-3 * (all - entered));
    EXPECT_LT(lit, 0.96 * all);
    const Rgb spotted =
        illuminance_from(spot, {}, Vec3(0), up, Unoccluded(), TubeModel::automatic, &coat);
    EXPECT_NEAR(spotted.g, 0.96 * 5000 / 9.0, 1e-9);
}

/// Beyond the end of a lamp, within its radius, the cap alone lights.
TEST(IlluminanceFrom, ACapIsHiddenToo) {
    const CPlane capped{.origin = {0, -50, 1000},
                        .u = {500, 0, 0},
                        .v = {0, 100, 0},
                        .lamps = 1,
                        .luminous_caps = true};
    const Vec3 beside(-20, 0, 1000), towards(1, 0, 0);
    EXPECT_GT(illuminance_from(capped, {}, beside, towards, Unoccluded()).r, 0);
    EXPECT_EQ(illuminance_from(capped, {}, beside, towards, AllHidden()).r, 0);
}
