// Notches, teeth and holes planted at random: each has a finding at its place.
#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/long_run.h"
#include "tests/unit/inspect/notched_sheets.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace keiko {
namespace {

using namespace test::notched;

constexpr double join = 0.5;

/// Borders of the lower sheet with one defect at random.
class Planter {
public:
    explicit Planter(unsigned seed) : random_(seed) {}

    std::vector<Vec2> next() {
        switch (std::uniform_int_distribution<int>(0, 2)(random_)) {
            case 0:
                return notch();
            case 1:
                return teeth();
            default:
                return plateau();
        }
    }

private:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    /// Notch of 11 to 80 degrees at its tip.
    std::vector<Vec2> notch() {
        const double deep = std::exp(between(std::log(0.3), std::log(20)));
        const double half = deep * std::tan(degrees_to_radians(between(11, 80)) / 2);
        const double x = between(30, 70), lean = between(-0.5, 0.5) * half;
        return {{x + half, 0}, {x + lean, -deep}, {x - half, 0}};
    }

    std::vector<Vec2> teeth() {
        std::vector<Vec2> border;
        const double size = std::exp(between(std::log(0.05), std::log(1)));
        for (double x = between(60, 90); x > 20; x -= size * between(0.3, 1.5))
            border.emplace_back(x, border.size() % 2 ? -size * between(0.3, 1.5) : 0);
        if (border.size() % 2 == 0) border.pop_back();
        return border;
    }

    std::vector<Vec2> plateau() {
        const double deep = std::exp(between(std::log(0.03), std::log(3)));
        const double long_ = std::exp(between(std::log(0.1), std::log(20)));
        const double x = between(30, 60), flank = between(0, 1.5) * deep;
        return {{x + long_ + flank, 0}, {x + long_, -deep}, {x, -deep}, {x - flank, 0}};
    }

    std::mt19937 random_;
};

/// Box of the corners of a hole: `upper` ones go up at `angle` degrees to the lower sheet.
Box3 box_of(const std::vector<Vec2>& lower, const std::vector<Vec2>& upper, double angle) {
    const double a = degrees_to_radians(angle);
    Box3 box;
    for (const Vec2& p : lower) box.extend({p.x, p.y, 0});
    for (const Vec2& p : upper) box.extend({p.x, -std::cos(a) * p.y, std::sin(a) * p.y});
    return box;
}

bool has_finding_in(const Inspection& inspection, const Box3& box) {
    const auto inside = [&](const Check& check) {
        return box.padded(0.01).contains(check.worst.place);
    };
    return std::any_of(inspection.findings.begin(), inspection.findings.end(), inside) ||
           std::any_of(inspection.looks.begin(), inspection.looks.end(), inside);
}

TEST(Openings, LeaveNoHoleWithoutAFindingWhateverTheAngleOfTheCrease) {
    std::mt19937 random(20261125);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const int cases = test::long_run() ? 2000 : 300;
    for (int i = 0; i < cases; ++i) {
        // Rectangles and diamonds with an outline of at most 50 mm, of one sheet or of both.
        const double half = std::exp(between(std::log(0.1), std::log(6)));
        const double low = std::exp(between(std::log(0.1), std::log(9)));
        const double high = i % 3 == 0 ? 0 : std::exp(between(std::log(0.1), std::log(9)));
        const double slant = i % 2 == 0 ? 0 : half, angle = between(15, 180);
        if (4 * half + 2 * (low + high) > 50) continue;
        const double right = 50 + half, left = 50 - half;
        std::vector<Vec2> upper{{left, 0}, {left + slant, high}, {right - slant, high}, {right, 0}};
        if (slant > 0) upper.erase(upper.begin() + 2);
        if (high == 0) upper.clear();
        std::vector<Vec2> lower{{right, 0}, {right - slant, -low}, {left + slant, -low}, {left, 0}};
        if (slant > 0) lower.erase(lower.begin() + 2);
        const Inspection found = inspect(holed_model(lower, upper, angle), {}, join);
        EXPECT_TRUE(has_finding_in(found, box_of(lower, upper, angle)))
            << "case " << i << ", " << half << ", " << low << ", " << high << " mm, " << slant
            << ", at " << angle << " degrees";
        const auto listed =
            std::count_if(found.looks.begin(), found.looks.end(),
                          [](const Check& look) { return look.code == "KEIKO-OPENING"; });
        // Where a small hole is a gap of the seam, only what is left on either side is an opening.
        EXPECT_LE(listed, found.verdict == Verdict::fail ? 2 : 1) << i;
    }
}

TEST(Openings, LeaveNoPlantedDefectWithoutAFinding) {
    Planter planter(20261124);
    CriteriaPreset preset;
    const int cases = test::long_run() ? 2000 : 300;
    for (int i = 0; i < cases; ++i) {
        const std::vector<Vec2> defect = planter.next();
        const Inspection found = inspect(notched_model(defect), preset, join);
        EXPECT_TRUE(has_finding_in(found, box_of(defect, {}, 180)))
            << "case " << i << ", " << defect.size() << " corners, the first at " << defect[0].x
            << ", the second at " << defect[1].x << ", " << defect[1].y;
        for (const Check& look : found.looks) EXPECT_LT(look.face, found.faces.size());
    }
    const Inspection clean = inspect(notched_model({}), preset, join);
    EXPECT_EQ(clean.verdict, Verdict::pass);
    EXPECT_TRUE(clean.looks.empty());
}

} // namespace
} // namespace keiko
