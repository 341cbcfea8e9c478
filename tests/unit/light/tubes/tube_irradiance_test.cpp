#include "keiko/light/tubes/tube_irradiance.h"

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/math/quadrature.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

using namespace keiko;

namespace {

TubeLamp lamp_in(const test::OracleRow& row) {
    return {row.vector("in.A"), row.vector("in.B"), row.number("in.d"), Rgb(row.number("in.L"))};
}

double lux(const test::OracleRow& row, TubeModel model,
           const IntervalSet& visible = IntervalSet::whole()) {
    return irradiance(lamp_in(row), row.vector("in.P"), row.unit("in.N"), visible, model).g;
}

/// Spheres that hide parts of a segment (docs/theory/visibility.md#shadows-in-closed-form).
class SphereShadows final : public Visibility {
public:
    using Visibility::intervals;
    SphereShadows(const Vec3& viewpoint, std::vector<double> spheres)
        : viewpoint_(viewpoint), spheres_(std::move(spheres)) {}

    IntervalSet intervals(const Segment& segment) const override {
        IntervalSet lit = IntervalSet::whole();
        for (std::size_t i = 0; i + 3 < spheres_.size(); i += 4)
            lit = lit.intersect(shadow(segment, i).complement());
        return lit;
    }

private:
    IntervalSet shadow(const Segment& segment, std::size_t i) const {
        const Vec3 c = Vec3(spheres_[i], spheres_[i + 1], spheres_[i + 2]) - viewpoint_;
        const double k = c.dot(c) - spheres_[i + 3] * spheres_[i + 3];
        const Vec3 v = segment.a - viewpoint_, w = segment.b - segment.a;
        const double q2 = std::pow(w.dot(c), 2) - w.dot(w) * k;
        const double q1 = v.dot(c) * w.dot(c) - v.dot(w) * k;
        const double q0 = std::pow(v.dot(c), 2) - v.dot(v) * k;
        const double disc = q1 * q1 - q2 * q0;
        if (disc <= 0) return {};
        const double t0 = (-q1 - std::sqrt(disc)) / q2, t1 = (-q1 + std::sqrt(disc)) / q2;
        return IntervalSet({{std::min(t0, t1), std::max(t0, t1)}});
    }

    Vec3 viewpoint_;
    std::vector<double> spheres_;
};

/// Parts of a segment that convex quads, 4 corners each, leave visible
/// (docs/theory/visibility.md#shadows-in-closed-form): each edge plane through the viewpoint is one
/// linear inequality in t.
IntervalSet lit_by_quads(const Segment& segment, const Vec3& viewpoint,
                         const std::vector<Vec3>& corners) {
    IntervalSet lit = IntervalSet::whole();
    for (std::size_t quad = 0; quad + 3 < corners.size(); quad += 4) {
        double begin = 0, end = 1;
        const Vec3 middle = (corners[quad] + corners[quad + 2]) * 0.5 - viewpoint;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 a = corners[quad + i] - viewpoint,
                       b = corners[quad + (i + 1) % 4] - viewpoint;
            Vec3 inwards = a.cross(b);
            if (inwards.dot(middle) < 0) inwards = -inwards;
            const double at = inwards.dot(segment.a - viewpoint);
            const double rise = inwards.dot(segment.b - segment.a);
            if (rise > 0) begin = std::max(begin, -at / rise);
            if (rise < 0) end = std::min(end, -at / rise);
            if (rise == 0 && at < 0) end = begin;
        }
        lit = lit.intersect(IntervalSet({{begin, end}}).complement());
    }
    return lit;
}

/// Brute force: the lateral surface in small facets.
double facets(const TubeLamp& lamp, const Vec3& point, const Vec3& normal) {
    const auto view = view_of(lamp, point, normal);
    const auto ring = [&](double phi) {
        const Vec3 out = view->towards * std::cos(phi) + view->sideways * std::sin(phi);
        return integrate(
            [&](double t) {
                const Vec3 to = lamp.a + (lamp.b - lamp.a) * t + out * view->radius - point;
                const double r2 = to.dot(to);
                const double lit = std::max(0.0, normal.dot(to)) * std::max(0.0, -out.dot(to));
                return lit / (r2 * r2) * view->radius * view->length;
            },
            0, 1, 64);
    };
    const double seen = std::acos(view->radius / view->distance);
    return integrate(ring, -seen, 0, 64) + integrate(ring, 0, seen, 64);
}

const TubeLamp lamp{{-600, 50, 800}, {600, -30, 900}, 26, Rgb(9000)};
const Vec3 normal = Vec3(0.2, -0.3, 1).normalized();

} // namespace

TEST(TubeIrradiance, AgreesWithOracle) {
    const test::OracleTable table("lamp_irradiance");
    test::WorstError rectangle("E_rect"), line("E_line"), strip("E_strip2"), nishita("E_eq1");
    for (const auto& row : table) {
        if (row.text("note").starts_with("P inside")) continue;
        rectangle.compare(row, lux(row, TubeModel::rectangle), row.number("out.E_rect"), 1e-11);
        line.compare(row, lux(row, TubeModel::line), row.number("out.E_line"), 1e-11);
        if (row.has("out.E_strip2"))
            strip.compare(row, lux(row, TubeModel::strip), row.number("out.E_strip2"), 1e-11);
        if (row.has("out.E_eq1"))
            nishita.compare(row, lux(row, TubeModel::nishita), row.number("out.E_eq1"), 1e-11);
    }
}

TEST(TubeIrradiance, CylinderAgreesWithOracle) {
    const test::OracleTable table("lamp_irradiance");
    test::WorstError worst("E_cyl_lateral");
    for (const auto& row : table)
        worst.compare(row, lux(row, TubeModel::cylinder), row.number("out.E_cyl_lateral"), 1e-9);
}

TEST(TubeIrradiance, LuminousCapsAgreeWithOracle) {
    const test::OracleTable table("lamp_irradiance");
    test::WorstError caps("E_cyl_caps"), total("E_cyl_total");
    for (const auto& row : table) {
        TubeLamp tube = lamp_in(row);
        tube.luminous_caps = true;
        const Vec3 point = row.vector("in.P"), n = row.unit("in.N");
        const double all = irradiance(tube, point, n, IntervalSet::whole(), TubeModel::cylinder).g;
        total.compare(row, all, row.number("out.E_cyl_total"), 1e-9);
        const double cap = tube.luminance.g * cap_solid_angle(tube, point, n);
        // The oracle's own error is absolute, that of the whole.
        const double slack = 1e-15 * row.number("out.E_cyl_total");
        caps.compare(row, cap, row.number("out.E_cyl_caps"), 1e-9, 1e-12 + slack);
    }
}

TEST(TubeIrradiance, AutomaticIsWithinItsErrorOnEveryRow) {
    const test::OracleTable table("lamp_irradiance");
    test::WorstError worst("automatic");
    for (const auto& row : table)
        worst.compare(row, lux(row, TubeModel::automatic), row.number("out.E_cyl_lateral"), 1e-4);
}

TEST(TubeIrradiance, CapsAreSeenWhereTheirEndIs) {
    TubeLamp tube = lamp;
    tube.luminous_caps = true;
    const Vec3 beyond = tube.b + (tube.b - tube.a) * 0.5 + Vec3(0, 0, 100);
    const Vec3 back = tube.a - tube.b;
    const auto omega = [&](const IntervalSet& visible) {
        return cap_solid_angle(tube, beyond, back.normalized(), visible);
    };
    EXPECT_GT(omega(IntervalSet::whole()), 0);
    EXPECT_EQ(omega(IntervalSet::whole(0.5, 1)), omega(IntervalSet::whole()));
    EXPECT_EQ(omega(IntervalSet::whole(0, 0.9)), 0);
    EXPECT_EQ(cap_solid_angle(tube, Vec3(0), normal), 0) << "between the ends";
}

TEST(TubeIrradiance, OnTheLineOfTheAxisADarkCappedLampIsDark) {
    const test::OracleTable table("lamp_irradiance");
    int rows = 0;
    for (const auto& row : table) {
        if (!row.text("note").starts_with("P inside")) continue;
        for (const auto model : {TubeModel::automatic, TubeModel::strip, TubeModel::line})
            EXPECT_EQ(lux(row, model), 0) << row.id();
        ++rows;
    }
    EXPECT_EQ(rows, 2);
}

TEST(TubeIrradiance, ErrorsOfTheModelsAreThoseOfTheOracle) {
    const test::OracleTable table("lamp_eq1_error");
    test::WorstError truth("E_over_L_true_lat");
    const std::vector<std::pair<TubeModel, std::string>> columns{
        {TubeModel::nishita, "out.relerr_eq1_lat"},
        {TubeModel::rectangle, "out.relerr_rect_lat"},
        {TubeModel::strip, "out.relerr_strip2_lat"},
        {TubeModel::line, "out.relerr_line_lat"}};
    for (const auto& row : table) {
        const double height = row.number("in.D"), foot = row.number("in.zf");
        const TubeLamp tube{{-foot, 0, height},
                            {row.number("in.len") - foot, 0, height},
                            row.number("in.d"),
                            Rgb(1)};
        const auto omega = [&](TubeModel model) {
            return projected_solid_angle(tube, Vec3(0), row.unit("in.N"), IntervalSet::whole(),
                                         model);
        };
        const double exact = row.number("out.E_over_L_true_lat");
        truth.compare(row, omega(TubeModel::cylinder), exact, 1e-11);
        for (const auto& [model, column] : columns)
            EXPECT_NEAR(omega(model) / exact - 1, row.number(column), 1e-12) << row.id() << column;
        EXPECT_NEAR(omega(TubeModel::automatic) / exact, 1, 1e-4) << row.id();
    }
}

TEST(TubeIrradiance, LineAgreesWithOracleDownToTheAxis) {
    const test::OracleTable table("line_irradiance");
    test::WorstError worst("E_cos");
    for (const auto& row : table) {
        const double d = 1e-12, luminance = row.number("in.Iq") / d;
        const TubeLamp thin{row.vector("in.A"), row.vector("in.B"), d, Rgb(luminance)};
        const double lx = irradiance(thin, row.vector("in.P"), row.unit("in.N"),
                                     IntervalSet::whole(), TubeModel::line)
                              .g;
        worst.compare(row, lx, row.number("out.E_cos"), 1e-11);
    }
}

TEST(TubeIrradiance, SumsOverTheVisiblePartsOfTheOracle) {
    const test::OracleTable table("lamp_occluded");
    test::WorstError line("E_line"), rectangle("E_rect_iv"), truth("E_rect_area"), open("E_unocc");
    for (const auto& row : table) {
        open.compare(row, lux(row, TubeModel::rectangle), row.number("out.E_unocc"), 1e-11);
        // Shadows of patches are found in the layer trace, which no lamp knows.
        if (row.has("in.bezier")) continue;
        const TubeLamp tube = lamp_in(row);
        const SphereShadows spheres(row.vector("in.P"), row.list("in.spheres"));
        const IntervalSet visible =
            row.has("in.quads")
                ? lit_by_quads({tube.a, tube.b}, row.vector("in.P"), row.points("in.quads"))
                : spheres.intervals({tube.a, tube.b});
        line.compare(row, lux(row, TubeModel::line, visible), row.number("out.E_line"), 1e-11);
        rectangle.compare(row, lux(row, TubeModel::rectangle, visible), row.number("out.E_rect_iv"),
                          1e-11);
        // Shadows that run along the lamp are beyond what intervals of its axis can say.
        if (row.text("note").starts_with("sphere shades")) continue;
        truth.compare(row, lux(row, TubeModel::rectangle, visible), row.number("out.E_rect_area"),
                      2e-3);
    }
}

TEST(TubeIrradiance, CylinderAgreesWithItsFacets) {
    const TubeLamp thick{{-300, 40, 200}, {500, -80, 250}, 150, Rgb(1)};
    const double omega = projected_solid_angle(thick, Vec3(10, 20, 30), Vec3(0, 0, 1),
                                               IntervalSet::whole(), TubeModel::cylinder);
    EXPECT_NEAR(omega, facets(thick, Vec3(10, 20, 30), Vec3(0, 0, 1)), 1e-9 * omega);
}

TEST(TubeIrradiance, PartsAddUpInEveryModel) {
    const IntervalSet visible({{0, 0.2}, {0.35, 0.6}, {0.8, 1}});
    for (const auto model : {TubeModel::nishita, TubeModel::rectangle, TubeModel::line,
                             TubeModel::strip, TubeModel::cylinder}) {
        const auto omega = [&](const IntervalSet& parts) {
            return projected_solid_angle(lamp, Vec3(0), normal, parts, model);
        };
        const double all = omega(IntervalSet::whole());
        // The paper takes chords for the angles of the short edges, which leaves a trace.
        const double tolerance = model == TubeModel::nishita ? 1e-5 : 1e-12;
        EXPECT_NEAR(omega(visible) + omega(visible.complement()), all, tolerance * all);
        EXPECT_GT(omega(visible.complement()), 0.1 * all);
        EXPECT_EQ(omega(IntervalSet()), 0);
    }
}

TEST(TubeIrradiance, PartsAddUpWhereTheHorizonCrosses) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    int crossing = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 n = Vec3(any(random), any(random), 0.1 * any(random)).normalized();
        const TubeLamp thick{{-600, 50, 300}, {600, -30, 400}, 120, Rgb(1)};
        const IntervalSet visible({{0.3, 0.55}, {0.7, 2}});
        const auto omega = [&](const IntervalSet& parts) {
            return projected_solid_angle(thick, Vec3(0), n, parts, TubeModel::cylinder);
        };
        const double all = omega(IntervalSet::whole());
        EXPECT_NEAR(omega(visible) + omega(visible.complement(0, 1)), all, 1e-10);
        crossing += n.dot(thick.a) * n.dot(thick.b) < 0;
    }
    EXPECT_GT(crossing, 50);
}

TEST(TubeIrradiance, ScalesAndTurnsWithTheScene) {
    const double omega = projected_solid_angle(lamp, Vec3(0), normal);
    const TubeLamp large{lamp.a * 1000, lamp.b * 1000, lamp.diameter * 1000, lamp.luminance};
    EXPECT_NEAR(projected_solid_angle(large, Vec3(0), normal), omega, 1e-13);
    const TubeLamp turned{lamp.b, lamp.a, lamp.diameter, lamp.luminance};
    EXPECT_NEAR(projected_solid_angle(turned, Vec3(0), normal), omega, 1e-13);
}

TEST(TubeIrradiance, CarriesColour) {
    TubeLamp blue = lamp;
    blue.luminance = {0, 100, 9000};
    const Rgb lx = irradiance(blue, Vec3(0), normal);
    EXPECT_EQ(lx.r, 0);
    EXPECT_NEAR(lx.b / lx.g, 90, 1e-12);
}

TEST(TubeIrradiance, VanishesBelowTheHorizonInsideTheGlassAndWithoutExtent) {
    for (const auto model :
         {TubeModel::automatic, TubeModel::nishita, TubeModel::line, TubeModel::cylinder}) {
        const auto omega = [&](const TubeLamp& tube, const Vec3& point, const Vec3& n) {
            return projected_solid_angle(tube, point, n, IntervalSet::whole(), model);
        };
        EXPECT_EQ(omega(lamp, Vec3(0), -normal), 0);
        EXPECT_EQ(omega(lamp, (lamp.a + lamp.b) * 0.5 + Vec3(0, 0, 5), normal), 0);
        EXPECT_EQ(omega({lamp.a, lamp.a, 26, Rgb(1)}, Vec3(0), normal), 0);
        EXPECT_EQ(omega({lamp.a, lamp.b, 0, Rgb(1)}, Vec3(0), normal), 0);
    }
    EXPECT_TRUE(below_horizon(lamp, Vec3(0), -normal));
    EXPECT_FALSE(below_horizon(lamp, Vec3(0), normal));
}
