#include "keiko/inspect/flaws/wave_section.h"

#include "keiko/inspect/flaws/geodesic_trace.h"

#include <array>
#include <cmath>

namespace keiko {
namespace {

/// A wave on one profile.
struct Wave {
    double depth = 0; ///< mm, upwards
    double length = 0;
    double crest = 0;  ///< mm along the profile
    double middle = 0; ///< middle of the two waves by which it is measured
};

/// Depth by the fourth difference over two waves, which cancels a form up to its third derivative.
double swing_at(const RoughnessProfile& profile, double middle, double length) {
    const auto height = [&](double waves) { return profile.height(middle + waves * length); };
    return (6 * height(0) - 4 * (height(0.5) + height(-0.5)) + height(1) + height(-1)) / 16;
}

/// A wave of this length with its crest at the given place. It is measured by the waves about the
/// crest or, if the profile is too short, about the next places half a wave apart.
std::optional<Wave> wave_at(const RoughnessProfile& profile, double crest, double length) {
    for (const int shift : {0, 1, -1, 2, -2}) {
        const double middle = crest + shift * length / 2;
        if (!profile.holds(middle - length) || !profile.holds(middle + length)) continue;
        const double swing = swing_at(profile, middle, length);
        return Wave{shift % 2 == 0 ? swing : -swing, length, crest, middle};
    }
    return std::nullopt;
}

/// The deepest wave near a first guess.
std::optional<Wave> deepest(const RoughnessProfile& profile, double side, double length) {
    auto best = wave_at(profile, 0, length);
    double step = 0.1;
    constexpr int halvings = 7, most_rounds = 60;
    for (int halved = 0, round = 0; best && halved < halvings && round < most_rounds; ++round) {
        bool moved = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const double crest = best->crest + way.x * step * length;
            if (!profile.holds(crest)) continue;
            const auto wave = wave_at(profile, crest, best->length * (1 + way.y * step));
            if (wave && wave->depth * side > best->depth * side) best = wave, moved = true;
        }
        if (!moved) step /= 2, ++halved;
    }
    return best;
}

/// A wave measured perpendicular to its form, which is the cubic that the fourth difference leaves
/// out. The profile is laid out flat: its slope is an angle, which is larger than its sine, and its
/// length is that of the trace up and down.
struct Upright {
    double depth = 0, length = 0; ///< mm
};

Upright upright(const RoughnessProfile& profile, double middle, double length) {
    const double swing = swing_at(profile, middle, length);
    const auto under = [&](int halves) { // the form under a crest or a trough
        return profile.height(middle + halves * length / 2) - (halves % 2 == 0 ? swing : -swing);
    };
    const double odd = (under(1) - under(-1)) / 2,
                 cubic = ((under(2) - under(-2)) / 2 - 2 * odd) / 6;
    const double linear = odd - cubic, square = (under(1) + under(-1)) / 2 - under(0);
    const auto above = [&](double halves) {
        const double form = halves * (linear + halves * (square + halves * cubic));
        return profile.height(middle + halves * length / 2) - form;
    };
    constexpr int steps = 24; // half a wave
    const double step = length / 2 / steps;
    std::array<double, 5> height{};
    double rise = 0, ahead = 0;
    for (int i = 0; i <= 4 * steps; ++i) {
        if (i % steps == 0) height[static_cast<std::size_t>(i / steps)] = rise;
        if (i == 4 * steps) break;
        const double at = static_cast<double>(i) / steps - 2;
        const double angle = (above(at + 1.0 / steps) - above(at)) / step;
        rise += step * std::sin(angle), ahead += step * std::cos(angle);
    }
    return {(6 * height[2] - 4 * (height[1] + height[3]) + height[0] + height[4]) / 16, ahead / 2};
}

/// The start of a profile, and the wave found there.
struct Found {
    SheetPoint at;
    double depth = 0, length = 0, bound = 0; ///< mm
};

std::optional<Found> found_from(const FaceAdjacency& faces, const SheetPoint& at, const Vec3& along,
                                double side, double length) {
    const auto profile = RoughnessProfile::through(faces, at, along, length);
    if (!profile) return std::nullopt;
    const auto wave = deepest(*profile, side, length);
    if (!wave) return std::nullopt;
    const double shorter = swing_at(*profile, wave->middle, 0.95 * wave->length);
    const Upright stands = upright(*profile, wave->middle, wave->length);
    return Found{profile->place(faces, wave->crest),
                 std::copysign(stands.depth, wave->depth * side), stands.length,
                 std::abs(std::abs(shorter) - std::abs(wave->depth))};
}

} // namespace

std::optional<WaveSection> wave_section(const FaceAdjacency& faces, const SheetPoint& at,
                                        const Vec3& along, bool crest, double length) {
    const double side = crest ? 1 : -1;
    auto best = found_from(faces, at, along, side, length);
    if (!best) return std::nullopt;
    double step = best->length / 8;
    constexpr int halvings = 5, most_rounds = 15;
    for (int halved = 0, round = 0; halved < halvings && round < most_rounds; ++round) {
        const auto frame = faces.frame(best->at, along);
        if (!frame) break;
        bool moved = false;
        for (const double way : {step, -step}) {
            const auto next = faces.moved(*frame, best->at, Vec2(0, way));
            if (!next) continue;
            const auto there = found_from(faces, *next, along, side, best->length);
            if (!there || there->depth <= best->depth) continue;
            best = there, moved = true;
            break;
        }
        if (!moved) step /= 2, ++halved;
    }
    return WaveSection{best->depth, best->length, best->bound, best->at,
                       faces.evaluate(best->at, 0)->position()};
}

} // namespace keiko
