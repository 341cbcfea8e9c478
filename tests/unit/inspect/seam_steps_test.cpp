#include "keiko/inspect/seams/seam_steps.h"

#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/measured_seams.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double length = 200; ///< mm of the seam

double bernstein_value(int degree, int k, double u) {
    double binomial = 1;
    for (int i = 0; i < k; ++i) binomial *= double(degree - i) / (i + 1);
    return binomial * std::pow(u, k) * std::pow(1 - u, degree - k);
}

/// A flat sheet beside the x axis, whose slope across it is that of one Bernstein polynomial.
struct Sheet {
    int degree = 1;
    int spike = -1;           ///< number of the polynomial; none below 0
    double weight = 1;        ///< of the last row of control points over that of the first
    double border_weight = 1; ///< of the end of the trim curve at the seam, over that of its begin
};

constexpr double planted = 1; ///< degrees, of a spike

std::vector<Vec4> points_of(const Sheet& sheet, double across) {
    const double peak = sheet.spike < 0 ? 1
                                        : bernstein_value(sheet.degree, sheet.spike,
                                                          double(sheet.spike) / sheet.degree);
    const double slope = std::tan(degrees_to_radians(planted)) / peak;
    std::vector<Vec4> points;
    for (int i = 0; i <= sheet.degree; ++i) {
        const double w = std::pow(sheet.weight, double(i) / sheet.degree);
        const double x = length * i / sheet.degree, z = i == sheet.spike ? -50 * slope : 0;
        points.push_back(Vec4(x, 0, 0, 1) * w);
        points.push_back(Vec4(x, across, z, 1) * w);
    }
    return points;
}

void add_sheet(test::ModelBuilder& builder, const Sheet& sheet, double across) {
    builder.rational_patch(sheet.degree, 1, points_of(sheet, across));
    if (sheet.border_weight == 1) return;
    const auto line = [](const Vec2& a, const Vec2& b, double w) {
        return std::vector<Vec3>{{a.x, a.y, 1}, {b.x * w, b.y * w, w}};
    };
    builder.loop({line({0, 0}, {1, 0}, sheet.border_weight), line({1, 0}, {1, 1}, 1),
                  line({1, 1}, {0, 1}, 1), line({0, 1}, {0, 0}, 1)});
}

SurfaceModel sheets(const Sheet& first, const Sheet& second) {
    test::ModelBuilder builder;
    add_sheet(builder, first, 50);
    add_sheet(builder, second, -50);
    return builder.build();
}

void expect_spike(const Sheet& first, const Sheet& second) {
    SCOPED_TRACE(testing::Message()
                 << first.degree << " " << first.spike << " " << first.weight << " "
                 << first.border_weight << " | " << second.degree << " " << second.spike << " "
                 << second.weight << " " << second.border_weight);
    const auto seams = test::measured(sheets(first, second));
    ASSERT_EQ(seams.size(), 1U);
    EXPECT_NEAR(seams[0].length, length, 1e-6);
    EXPECT_LT(seams[0].gap.value, 1e-6);
    ASSERT_TRUE(seams[0].angle);
    EXPECT_NEAR(seams[0].angle->value, planted, 1e-4);
    EXPECT_EQ(seams[0].verdict, Verdict::fail);
}

/// Spikes of different widths and places.
std::vector<Sheet> spiked() {
    std::vector<Sheet> all;
    for (const int k : {1, 3, 8, 12, 17, 22, 24}) all.push_back({25, k});
    for (const int k : {1, 4, 8}) all.push_back({9, k});
    return all;
}

TEST(SeamSteps, ShowASpikeBesideASideOfUnequalWeights) {
    for (const double ratio : {10.0, 300.0, 3000.0, 9999.0})
        for (const double weight : {ratio, 1 / ratio})
            for (const Sheet& spike : spiked()) {
                expect_spike({1, -1, weight}, spike);
                expect_spike(spike, {1, -1, weight});
            }
}

TEST(SeamSteps, ShowASpikeOfASideOfUnequalWeights) {
    for (const double ratio : {10.0, 300.0, 9999.0})
        for (const double weight : {ratio, 1 / ratio})
            for (Sheet spike : spiked()) {
                spike.weight = weight;
                expect_spike({}, spike);
                expect_spike(spike, {1, -1, 1 / weight});
            }
}

TEST(SeamSteps, ShowASpikeBesideATrimCurveOfUnequalWeights) {
    for (const double ratio : {30.0, 1e4, 9e5})
        for (const double weight : {ratio, 1 / ratio})
            for (const Sheet& spike : spiked()) {
                Sheet trimmed_spike = spike;
                trimmed_spike.border_weight = weight;
                expect_spike({1, -1, 1, weight}, spike);
                expect_spike(spike, {1, -1, 1, weight});
                expect_spike({}, trimmed_spike);
                expect_spike({1, -1, 1, weight}, trimmed_spike);
            }
}

TEST(SeamSteps, AreEvenInLength) {
    for (const double weight : {1.0, 1e-3, 9999.0}) {
        const SurfaceModel model = sheets({1, -1, weight}, {1, -1, 1 / weight});
        const BoundaryCurves curves(model);
        const SeamProbe probe(curves, pair_seams(model, test::join).at(0));
        const std::vector<SeamStep> steps = probe.steps(16);
        EXPECT_EQ(steps.front().t, probe.begin());
        EXPECT_EQ(steps.back().t, probe.end());
        for (std::size_t i = 1; i < steps.size(); ++i) {
            EXPECT_LT(steps[i - 1].t, steps[i].t);
            EXPECT_LT((probe.place(steps[i].t) - probe.place(steps[i - 1].t)).length(),
                      1.3 * length * std::numbers::pi / 2 / 16);
        }
        EXPECT_LT(steps.size(), 80U) << weight;
    }
}

TEST(SeamSteps, TrimCurvesOfWeightsThatNumbersDoNotTellApartAreUndecided) {
    for (const double weight : {1e5, 1e7, 1e-7, 1e9, 1e12}) {
        const Sheet sheet{1, -1, 1, weight};
        const Inspection found = inspect(sheets(sheet, sheet));
        const bool refused = weight != 1e5;
        EXPECT_EQ(found.verdict, refused ? Verdict::undecided : Verdict::pass) << weight;
        ASSERT_EQ(found.findings.size(), refused ? 2U : 0U) << weight;
        if (!refused) continue;
        EXPECT_EQ(found.findings[0].faces, "face 1");
        EXPECT_NE(found.findings[0].message.find("a border curve"), std::string::npos)
            << found.findings[0].message;
    }
}

} // namespace
} // namespace keiko
