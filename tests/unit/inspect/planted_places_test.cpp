#include "keiko/base/units.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/support/long_run.h"
#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

/// Spurs, folds, partial overlaps and creases that fade, planted at random into the seam of two
/// sheets, against the angle sampled along it in closed form.
namespace keiko {
namespace {

constexpr double length = 300, width = 50; ///< mm
constexpr double join = 0.5;               ///< mm
constexpr int samples = 30001;

/// The angle of the second sheet along the seam: cubic from one break to the next.
struct Profile {
    std::vector<double> breaks{0}; ///< mm
    std::vector<double> angles;    ///< degrees, three a span and the last one

    void go_on(double to, double first, double second, double third, double last) {
        if (angles.empty()) angles.push_back(first);
        angles.back() = first;
        angles.insert(angles.end(), {second, third, last});
        breaks.push_back(to);
    }
    void hold(double to, double angle) { go_on(to, angle, angle, angle, angle); }

    static Vec3 direction(double degrees) {
        const double angle = degrees_to_radians(degrees);
        return {0, -std::cos(angle), -std::sin(angle)};
    }

    /// Degrees, of the surface itself, whose directions are interpolated.
    double at(double place) const {
        const double x = std::min(place, breaks.back());
        std::size_t span = 0;
        while (span + 2 < breaks.size() && x > breaks[span + 1]) ++span;
        const double t = (x - breaks[span]) / (breaks[span + 1] - breaks[span]), r = 1 - t;
        const double weights[] = {r * r * r, 3 * r * r * t, 3 * r * t * t, t * t * t};
        Vec3 sum(0);
        for (std::size_t i = 0; i < 4; ++i) sum += direction(angles[3 * span + i]) * weights[i];
        return radians_to_degrees(std::atan2(std::abs(sum.z), -sum.y));
    }

    NurbsSurface sheet() const {
        NurbsSurface sheet{3, 1, {breaks.front()}, {0, 0, 1, 1}, {}};
        for (const double b : breaks) sheet.knots_u.insert(sheet.knots_u.end(), 3, b);
        sheet.knots_u.push_back(breaks.back());
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const std::size_t span = std::min(i / 3, breaks.size() - 2);
            const double share = double(i - 3 * span) / 3;
            const double x = breaks[span] + share * (breaks[span + 1] - breaks[span]);
            const Vec3 far = Vec3(x, 0, 0) + direction(angles[i]) * width;
            sheet.points.emplace_back(x, 0, 0, 1);
            sheet.points.emplace_back(far.x, far.y, far.z, 1);
        }
        return sheet;
    }
};

struct Case {
    Profile profile;
    double spur = 0; ///< mm, by which the first sheet's border overshoots and folds back
    double begin = 0, end = length; ///< mm, of the first sheet's border
    bool must_fail = false;         ///< whatever the angle's size, its fading has a corner
    bool must_pass = false;
};

SurfaceModel model_of(const Case& c) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, width, 0});
    const double a = c.begin / length, b = c.end / length, back = (c.end - c.spur) / length;
    if (c.spur > 0)
        builder.polygon({{a, 0}, {b, 0}, {back, 0}, {back, 1}, {a, 1}});
    else
        builder.polygon({{a, 0}, {b, 0}, {b, 1}, {a, 1}});
    builder.nurbs(c.profile.sheet());
    return builder.build();
}

/// The length along which an angle between the limit and the feature angle, or of a fold, is not
/// excused by a crease that fades there.
double length_over_limits(const Case& c, const CriteriaPreset& preset) {
    std::vector<double> angle;
    for (int i = 0; i < samples; ++i) angle.push_back(c.profile.at(length * i / (samples - 1)));
    const double step = length / (samples - 1);
    std::vector<bool> excused(angle.size());
    const auto excuse = [&](int from, int way, double crease) {
        std::vector<int> run;
        double lowest = 180;
        for (int i = from; i >= 0 && i < samples; i += way) {
            const double here = angle[static_cast<std::size_t>(i)];
            lowest = std::min(lowest, here);
            if (here > lowest + preset.angle || double(run.size()) * step > preset.longest_run_out)
                return;
            if (here <= preset.angle) {
                if (double(run.size()) * step > crease + 2 * step) return;
                for (const int k : run) excused[static_cast<std::size_t>(k)] = true;
                return;
            }
            run.push_back(i);
        }
    };
    const auto is_crease = [&](int i) {
        const double here = angle[static_cast<std::size_t>(i)];
        return here > preset.feature_angle && here <= 179;
    };
    for (int i = 0, begin = 0; i < samples; ++i) {
        if (!is_crease(i)) continue;
        if (i == 0 || !is_crease(i - 1)) begin = i;
        if (i + 1 < samples && is_crease(i + 1)) continue;
        excuse(begin - 1, -1, (i - begin) * step);
        excuse(i + 1, 1, (i - begin) * step);
    }
    double over = 0;
    for (int i = 0; i < samples; ++i) {
        const double x = length * i / (samples - 1), here = angle[static_cast<std::size_t>(i)];
        if (x < c.begin || x > c.end || excused[static_cast<std::size_t>(i)]) continue;
        if (here > 179 || (here > preset.angle && here <= preset.feature_angle)) over += step;
    }
    return over;
}

/// The seams that do not pass.
std::string description(const std::vector<MeasuredSeam>& seams) {
    std::ostringstream text;
    const auto add = [&](const char* name, const MeasuredValue& worst) {
        text << ", " << name << ' ' << worst.value << " +- " << worst.bound << " at "
             << worst.place.x;
    };
    for (const MeasuredSeam& seam : seams) {
        if (seam.verdict == Verdict::pass) continue;
        text << "\n" << name_of(seam.kind) << ", " << seam.length << " mm";
        add("gap", seam.gap);
        if (seam.angle) add("angle", *seam.angle);
        if (seam.curvature) add("curvature", seam.curvature->worst);
        if (seam.fading) add("fading", *seam.fading);
    }
    return text.str();
}

class Planter {
public:
    explicit Planter(unsigned seed) : random_(seed) {}

    Case next() {
        Case c;
        switch (pick(6)) {
            case 0:
                plant_constant(c);
                break;
            case 1:
                plant_fold(c);
                break;
            case 2:
                plant_bump(c);
                break;
            case 3:
                plant_fading(c, true);
                break;
            case 4:
                plant_fading(c, false);
                break;
            default:
                plant_plateau(c);
        }
        if (pick(2)) c.spur = std::pow(10, between(-3.5, -1.5));
        if (pick(4) == 0 && !c.must_fail && !c.must_pass) c.begin = between(1, 40);
        return c;
    }

private:
    int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    void plant_constant(Case& c) {
        const double angle = between(0, 0.3);
        c.profile.hold(length, angle);
        c.must_pass = angle<0.0999, c.must_fail = angle> 0.1001;
    }

    /// Folded back along some of the way, from a thousandth of a millimetre to half of it.
    void plant_fold(Case& c) {
        const double base = between(0, 0.2), at = between(50, 150);
        const double folded = std::pow(10, between(-3, 2)), turn = std::pow(10, between(-3, 0.5));
        c.profile.hold(at, base);
        c.profile.go_on(at + turn, base, base, 180, 180);
        c.profile.hold(at + turn + folded, 180);
        c.profile.go_on(at + 2 * turn + folded, 180, 180, base, base);
        c.profile.hold(length, base);
    }

    /// An angle over the limit along some of the way.
    void plant_bump(Case& c) {
        const double at = between(50, 150), bump = std::pow(10, between(-2.5, 1.5));
        const double angle = between(0.12, 9);
        c.profile.hold(at, 0);
        if (pick(2)) {
            c.profile.go_on(at + bump, 0, angle, angle, 0);
        } else {
            c.profile.go_on(at + bump / 2, 0, 0, angle, angle);
            c.profile.go_on(at + bump, angle, angle, 0, 0);
        }
        c.profile.hold(length, 0);
    }

    /// A crease that fades to nothing, with or without a corner at its end.
    void plant_fading(Case& c, bool smooth) {
        // Round lengths too, whose samples are evenly apart.
        const bool round = pick(2) == 0;
        const double sharp = between(6, 25), fading = round ? 50 : between(40, 100);
        const double at = round ? 100 : between(100, 150);
        c.profile.hold(at, sharp);
        if (smooth)
            c.profile.go_on(at + fading, sharp, sharp, 0, 0);
        else
            c.profile.go_on(at + fading, sharp, sharp * 2 / 3, sharp / 3, 0);
        if (pick(3) > 0 || !smooth)
            c.profile.hold(length, 0);
        else
            c.end = at + fading;
        c.must_pass = smooth, c.must_fail = !smooth;
    }

    /// A crease that fades to an angle which is over the limit and stays there.
    void plant_plateau(Case& c) {
        const double sharp = between(6, 25), at = between(20, 100), rest = between(0.15, 4.5);
        c.profile.hold(at, sharp);
        c.profile.go_on(at + 80, sharp, sharp, rest, rest);
        c.profile.hold(length, rest);
    }

    std::mt19937 random_;
};

TEST(PlantedPlaces, NoSeamPassesThatIsOverALimitForMoreThanIsNegligible) {
    const CriteriaPreset preset;
    Planter planter(20261124);
    const int cases = test::long_run() ? 100000 : 10000;
    int over = 0, passed = 0;
    for (int i = 0; i < cases; ++i) {
        const Case c = planter.next();
        const SurfaceModel model = model_of(c);
        const auto measured = measure_seams(model, pair_seams(model, join), preset, join).seams;
        Verdict verdict = Verdict::pass;
        for (const MeasuredSeam& seam : measured) verdict = std::max(verdict, seam.verdict);
        const double length_over = length_over_limits(c, preset);
        over += length_over > preset.negligible, passed += verdict == Verdict::pass;
        if (length_over > preset.negligible + 0.02 || c.must_fail) {
            EXPECT_NE(verdict, Verdict::pass)
                << "case " << i << ", over by " << length_over << " mm";
        }
        if (c.must_pass) {
            EXPECT_EQ(verdict, Verdict::pass) << "case " << i << description(measured);
        }
    }
    EXPECT_GT(over, cases / 4);
    EXPECT_GT(passed, cases / 8);
}

} // namespace
} // namespace keiko
