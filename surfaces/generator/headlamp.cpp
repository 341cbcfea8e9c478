#include "digits.h"
#include "fixtures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr double kCutOff = -0.57; ///< degrees, of the beam to the left
constexpr double kElbow = 15;     ///< degrees by which the cut-off rises to the right
constexpr double kHighest = 2;    ///< degrees, where it ends to rise
constexpr double kBlur = 0.15;    ///< degrees over which the cut-off fades
constexpr double kStray = 120;    ///< cd above it

/// Up in steps that are finest about the cut-off.
const std::vector<double> kVertical{-20,  -16,   -13,  -10,   -8,  -6.5, -5,   -4,   -3,   -2.5,
                                    -2,   -1.75, -1.5, -1.25, -1,  -0.9, -0.8, -0.7, -0.6, -0.5,
                                    -0.4, -0.3,  -0.2, -0.1,  0,   0.25, 0.5,  0.75, 1,    1.25,
                                    1.5,  1.75,  2,    2.25,  2.5, 3,    4,    6,    10};
/// To the right.
const std::vector<double> kHorizontal{-45, -38, -32, -27, -23, -19, -16, -13, -10, -8, -6, -4,
                                      -3,  -2,  -1,  0,   1,   2,   3,   4,   5,   6,  7,  8,
                                      9,   10,  12,  14,  16,  19,  23,  27,  32,  38, 45};

double bell(double x, double width) {
    return std::exp(-x * x / (width * width));
}

/// Elevation below which a low beam for traffic on the right shines.
double cut_off(double h) {
    const double slope = std::tan(kElbow * std::numbers::pi / 180);
    return h < 0 ? kCutOff : std::min(kCutOff + slope * h, kHighest);
}

/// cd: a narrow beam below the cut-off, a wide one in front of the car.
double candela(double v, double h) {
    const double below = 1 / (1 + std::exp((v - cut_off(h)) / kBlur));
    const double beam = 21000 * bell(h - 1.5, 7) * bell(v + 1.1, 1.6);
    const double wide = 5200 * bell(h, 24) * bell(v + 3, 5);
    const double rim = std::clamp((45 - std::abs(h)) / 10, 0.0, 1.0);
    return std::round(((beam + wide) * below + kStray * bell(v, 5)) * rim);
}

std::string line(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : " ") + digits(value);
    return text;
}

} // namespace

TextFixture headlamp() {
    TextFixture fixture{"headlamp.ies", {}, {}};
    const auto count = [](const std::vector<double>& angles) {
        return static_cast<double>(angles.size());
    };
    fixture.lines = {"IESNA:LM-63-2002",
                     "[TEST] computed, not measured",
                     "[TESTLAB] Keiko",
                     "[ISSUEDATE] 2026-01-01",
                     "[MANUFAC] Keiko",
                     "[LUMINAIRE] low beam of a car for traffic on the right",
                     "TILT=NONE",
                     line({1, -1, 1, count(kVertical), count(kHorizontal), 3, 2, 0.15, 0.15, 0}),
                     line({1, 1, 35}),
                     line(kVertical),
                     line(kHorizontal)};
    double most = 0;
    for (const double h : kHorizontal) {
        std::vector<double> plane;
        for (const double v : kVertical) plane.push_back(candela(v, h));
        most = std::max(most, *std::max_element(plane.begin(), plane.end()));
        fixture.lines.push_back(line(plane));
    }
    const double glare = candela(0.5, -3), road = candela(-0.9, 1);
    fixture.truths = {{"largest intensity", "cd", 25384, most, 1},
                      {"half a degree up, 3 degrees to the left", "cd", 125, glare, 1},
                      {"0.9 degrees down, a degree to the right", "cd", 24583, road, 1}};
    return fixture;
}

} // namespace keiko::fixtures
