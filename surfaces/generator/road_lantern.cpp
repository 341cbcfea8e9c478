#include "digits.h"
#include "fixtures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

using std::numbers::pi;

constexpr double kFlux = 6000;            // lm
constexpr int kStepV = 5, kPlanesV = 19;  // 0 to 90 degrees
constexpr int kStepH = 15, kPlanesH = 13; // 90, the street, over 180, along it, to 270, the houses

double bell(double x, double width) {
    return std::exp(-x * x / (width * width));
}

/// A beam that reaches far along the road and a little over it, some light below, none above.
double shape(double v, double h) {
    const double theta = v * pi / 180, phi = h * pi / 180;
    const double beam = 2.6 * bell(v - 64, 12) * bell(h - 163, 22);
    const double below = std::cos(theta) * (1 + 0.6 * std::sin(theta) * std::sin(phi));
    const double cut_off = std::clamp((90 - v) / 12, 0.0, 1.0);
    return (beam + below) * cut_off;
}

/// lm of candela at the nodes, by the trapezoidal rule over h and over cos v.
double flux(const std::vector<std::vector<double>>& candela) {
    double sum = 0;
    for (int i = 0; i < kPlanesH; ++i)
        for (int j = 0; j + 1 < kPlanesV; ++j) {
            const double share = i == 0 || i == kPlanesH - 1 ? 0.5 : 1;
            const double zone =
                std::cos(j * kStepV * pi / 180) - std::cos((j + 1) * kStepV * pi / 180);
            const auto& plane = candela[static_cast<std::size_t>(i)];
            const auto at = static_cast<std::size_t>(j);
            sum += share * zone * (plane[at] + plane[at + 1]) / 2;
        }
    return 2 * sum * kStepH * pi / 180; // the other half mirrors this one
}

std::vector<std::vector<double>> table() {
    std::vector<std::vector<double>> candela;
    for (int i = 0; i < kPlanesH; ++i) {
        candela.emplace_back();
        for (int j = 0; j < kPlanesV; ++j)
            candela.back().push_back(shape(j * kStepV, 90 + i * kStepH));
    }
    const double scale = kFlux / flux(candela);
    for (auto& plane : candela)
        for (double& value : plane) value = std::round(value * scale);
    return candela;
}

std::string line(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : " ") + digits(value);
    return text;
}

std::vector<double> angles(double first, int step, int count) {
    std::vector<double> all;
    for (int i = 0; i < count; ++i) all.push_back(first + i * step);
    return all;
}

} // namespace

TextFixture road_lantern() {
    const auto candela = table();
    TextFixture fixture{"road-lantern.ies", {}, {}};
    fixture.lines = {"IESNA:LM-63-2002",
                     "[TEST] computed, not measured",
                     "[TESTLAB] Keiko",
                     "[ISSUEDATE] 2026-01-01",
                     "[MANUFAC] Keiko",
                     "[LUMINAIRE] road lantern with a beam along the road to both sides",
                     "TILT=NONE",
                     line({1, -1, 1, kPlanesV, kPlanesH, 1, 2, 0.3, 0.7, 0}),
                     line({1, 1, 55}),
                     line(angles(0, kStepV, kPlanesV)),
                     line(angles(90, kStepH, kPlanesH))};
    for (const auto& plane : candela) fixture.lines.push_back(line(plane));
    fixture.truths = {{"luminous flux", "lm", kFlux, flux(candela), 0.001 * kFlux},
                      {"on the axis, largest less least", "cd", 0,
                       candela.front().front() - candela.back().front(), 0}};
    return fixture;
}

} // namespace keiko::fixtures
