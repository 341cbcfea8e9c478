#include "keiko/files/scene/preset_file.h"
#include "keiko/inspect/flaws/flaw_search.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/random.h"
#include "tests/unit/inspect/dented_panel.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::dented_panel, test::half_panel, test::PanelHeight, test::planted_depth, test::Random,
    test::RoundDent, test::uniform;

/// A form without features: bent by up to 1/`radius` either way, with a cubic part and long waves.
PanelHeight smooth_form(Random& random, double radius) {
    const auto bend = [&] {
        const double share = uniform(random, -1, 1); // most panels are flatter
        return share * share * share / radius;
    };
    const double x2 = bend(), y2 = bend();
    const double x3 = uniform(random, -2e-7, 2e-7), y3 = uniform(random, -2e-7, 2e-7);
    const double length = uniform(random, 400, 1200), phase = uniform(random, 0, 6);
    const double height = uniform(random, 0, 2.5e-6) * length * length;
    return [=](double x, double y) {
        const double along = 2 * std::numbers::pi * (0.6 * x + 0.8 * y) / length + phase;
        return x2 * x * x / 2 + y2 * y * y / 2 + x3 * x * x * x + y3 * y * y * y +
               height * std::sin(along);
    };
}

/// A crowned line, `radius` mm sharp, that runs past a place at a distance.
PanelHeight feature_line(const PanelHeight& form, Random& random, const Vec2& place, double away) {
    const double angle = uniform(random, 0, 6.28), radius = uniform(random, 100, 400);
    const double slope = uniform(random, 0.05, 0.3), width = slope * radius;
    const Vec2 normal(std::cos(angle), std::sin(angle));
    return [=](double x, double y) {
        const double off = normal.dot(Vec2(x, y) - place) - away;
        return form(x, y) - slope * (std::hypot(width, off) - width);
    };
}

RoundDent random_dent(Random& random, double smallest, double largest) {
    RoundDent dent;
    dent.diameter = uniform(random, smallest, largest);
    dent.depth = std::exp(uniform(random, std::log(0.012), std::log(0.5)));
    if (test::pick(random, 2) == 0) dent.depth = -dent.depth;
    dent.profile = static_cast<RoundDent::Profile>(test::pick(random, 4));
    return dent;
}

/// The flaws of a panel by the search alone, which is most of what a test of many panels takes.
std::vector<Flaw> found_in(const SurfaceModel& model) {
    const MeasuredSeams measured = measure_seams(model, pair_seams(model, 0.5), {}, 0.5);
    const std::vector<bool> searched(model.faces.size(), true);
    const std::array<WavinessLimit, 1> limits{{{0.01, 100}}};
    std::vector<Flaw> found;
    for (const std::vector<Flaw>& of_face :
         find_flaws(model, measured.seams, measured.pieces, searched, limits))
        found.insert(found.end(), of_face.begin(), of_face.end());
    return found;
}

/// Holds the deepest flaw of a panel against what is planted.
void expect_honest(const std::vector<Flaw>& found, double truth, double widest_share) {
    ASSERT_FALSE(found.empty()) << truth;
    const MeasuredValue& depth = found[0].depth;
    EXPECT_LE(std::abs(depth.value - truth), depth.bound + 2e-3 * truth) << depth.value;
    EXPECT_LT(depth.bound, widest_share * depth.value) << truth;
    EXPECT_NE(depth.verdict, Verdict::pass) << depth.value << ' ' << truth;
}

/// Dents up to 0.7 windows wide in panels bent by up to 1/200 mm, inside a face or over a seam.
TEST(DentsInPanels, AreMeasuredWithinATenth) {
    for (int i = 0; i < 16; ++i) {
        SCOPED_TRACE(i);
        Random random(1000 + static_cast<unsigned>(i));
        const PanelHeight form = smooth_form(random, 200);
        RoundDent dent = random_dent(random, 20, 70);
        dent.centre = {uniform(random, -60, 60), uniform(random, -60, 60)};
        std::optional<double> cut;
        if (i % 3 == 0) cut = dent.centre.x + uniform(random, -40, 40);
        expect_honest(found_in(dented_panel(form, dent, cut)), planted_depth(form, dent), 0.1);
    }
}

/// The dent of 0.05 mm on a diameter of 60 mm fails by the preset whose window is 100 mm.
TEST(DentsInPanels, OneOfSixtyMillimetresFailsByThePreset) {
    const PanelHeight form = [](double x, double y) { return -x * x / 3000 - y * y / 5000; };
    for (const auto profile : {RoundDent::Profile::square, RoundDent::Profile::cube,
                               RoundDent::Profile::fourth, RoundDent::Profile::cosine}) {
        const RoundDent dent{{13, -7}, 60, 0.05, profile};
        const Inspection found =
            inspect(dented_panel(form, dent), preset_by_name("class-a-waviness"));
        ASSERT_EQ(found.findings.size(), 1u);
        const MeasuredValue& worst = found.findings[0].worst;
        EXPECT_EQ(worst.verdict, Verdict::fail) << found.findings[0].message;
        EXPECT_LT(worst.bound, worst.value / 10);
        EXPECT_NEAR(worst.value, planted_depth(form, dent), worst.bound + 1e-4);
    }
}

/// The default preset reports what it does not judge, and the verdict stays as it is.
TEST(DentsInPanels, AreWorthALookByTheDefaultPreset) {
    const PanelHeight form = [](double x, double y) { return -x * x / 3000 - y * y / 5000; };
    const RoundDent dent{{13, -7}, 60, 0.05, RoundDent::Profile::cosine};
    const Inspection found = inspect(dented_panel(form, dent), preset_by_name("class-a-outer"));
    EXPECT_EQ(found.verdict, Verdict::pass);
    EXPECT_EQ(found.faces.at(0).verdict, Verdict::pass);
    EXPECT_TRUE(found.findings.empty());
    ASSERT_EQ(found.looks.size(), 1u);
    const Check& look = found.looks[0];
    EXPECT_EQ(look.code, "KEIKO-DENT");
    EXPECT_EQ(look.severity, Check::Severity::look);
    EXPECT_TRUE(look.is_worth_a_look());
    EXPECT_FALSE(look.is_finding());
    EXPECT_EQ(outcome_of(look), "look");
    RoundDent shallow = dent;
    shallow.depth = 0.007;
    EXPECT_TRUE(
        inspect(dented_panel(form, shallow), preset_by_name("class-a-outer")).looks.empty());
}

TEST(DentsInPanels, AnUndecidedOneStatesItsBound) {
    MeasuredFace face;
    face.curvature.emplace();
    MeasuredValue depth{0.0486, 0.037, 0.01, Vec3(0), Verdict::undecided, false};
    face.flaws = {{Flaw::Kind::dent, depth, 60, 100}};
    CriteriaPreset preset;
    preset.surface.waviness = {{0.01, 100}};
    const std::vector<Check> checks = checks_of(face, preset, 0);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].message,
              "the dent of 0.0486 ± 0.0370 mm cannot be told from the limit of "
              "0.01 mm, some 60 mm wide");
}

/// Beside crowned feature lines, down to a quarter of a window from the rim: the bound widens.
TEST(DentsInPanels, AreMeasuredHonestlyBesideFeatureLines) {
    for (int i = 0; i < 8; ++i) {
        SCOPED_TRACE(i);
        Random random(2000 + static_cast<unsigned>(i));
        RoundDent dent = random_dent(random, 20, 50);
        dent.depth *= 3;
        dent.centre = {uniform(random, -30, 30), uniform(random, -30, 30)};
        const double away = dent.diameter / 2 + uniform(random, 25, 80);
        const PanelHeight form = feature_line(smooth_form(random, 500), random, dent.centre, away);
        expect_honest(found_in(dented_panel(form, dent)), planted_depth(form, dent), 3);
    }
}

/// Dents up to half a window wide whose middle lies near a border.
TEST(DentsInPanels, AreMeasuredHonestlyBesideBorders) {
    for (int i = 0; i < 8; ++i) {
        SCOPED_TRACE(i);
        Random random(3000 + static_cast<unsigned>(i));
        const PanelHeight form = smooth_form(random, 400);
        RoundDent dent = random_dent(random, 20, 50);
        const double beside = uniform(random, 0.5, 1.5) * dent.diameter;
        dent.centre = {half_panel - beside, uniform(random, -60, 60)};
        expect_honest(found_in(dented_panel(form, dent)), planted_depth(form, dent), 3);
    }
}

/// Panels with a feature line and without a dent.
TEST(DentsInPanels, NothingIsFoundWhereNothingIsPlanted) {
    for (int i = 0; i < 8; ++i) {
        SCOPED_TRACE(i);
        Random random(4000 + static_cast<unsigned>(i));
        RoundDent none;
        none.diameter = 1;
        const PanelHeight form =
            feature_line(smooth_form(random, 200), random, {0, 0}, uniform(random, -80, 80));
        for (const Flaw& flaw : found_in(dented_panel(form, none)))
            EXPECT_EQ(flaw.depth.verdict, Verdict::pass) << flaw.depth.value;
    }
}

} // namespace
} // namespace keiko
