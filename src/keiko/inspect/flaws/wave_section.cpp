#include "keiko/inspect/flaws/wave_section.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr double profile_reach = 2.5; ///< waves
constexpr double profile_steps = 24;  ///< a wave
constexpr std::size_t fewest_samples = 8;

/// Numerov's method, of order 4, for w'' = k.
std::vector<double> integrated(const std::vector<WalkPoint>& points, double step) {
    std::vector<double> w(points.size(), 0);
    const auto bend = [&](std::size_t i) { return points[i].bend.xx; };
    for (std::size_t i = 1; i + 1 < w.size(); ++i)
        w[i + 1] =
            2 * w[i] - w[i - 1] + step * step / 12 * (bend(i - 1) + 10 * bend(i) + bend(i + 1));
    return w;
}

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

/// Depth by the third difference over one and a half waves, positive if a crest is before the
/// middle. It cancels a form up to its second derivative.
double narrow_swing_at(const RoughnessProfile& profile, double middle, double length) {
    const auto height = [&](double waves) { return profile.height(middle + waves * length); };
    return (3 * (height(-0.25) - height(0.25)) + height(0.75) - height(-0.75)) / 8;
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

/// A wave measured by one and a half waves, for a profile too short for two.
std::optional<Wave> narrow_wave_at(const RoughnessProfile& profile, double crest, double length) {
    for (const int shift : {1, -1, 3, -3}) {
        const double middle = crest + shift * length / 4;
        if (!profile.holds(middle - 0.75 * length) || !profile.holds(middle + 0.75 * length))
            continue;
        const double swing = narrow_swing_at(profile, middle, length);
        return Wave{shift == 1 || shift == -3 ? swing : -swing, length, crest, middle};
    }
    return std::nullopt;
}

/// The deepest wave near a first guess.
template <class WaveAt>
std::optional<Wave> deepest(const RoughnessProfile& profile, double side, double length,
                            const WaveAt& wave_at) {
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
    const auto wave = deepest(*profile, side, length, wave_at);
    if (!wave) return std::nullopt;
    const double shorter = swing_at(*profile, wave->middle, 0.95 * wave->length);
    const Upright stands = upright(*profile, wave->middle, wave->length);
    return Found{profile->place(faces, wave->crest),
                 std::copysign(stands.depth, wave->depth * side), stands.length,
                 std::abs(std::abs(shorter) - std::abs(wave->depth))};
}

/// Part of a third difference that a form makes if its bend changes by as much as it is.
double bend_at(const RoughnessProfile& profile, double middle, double length) {
    const auto pair = [&](double waves) {
        return profile.height(middle + waves * length) + profile.height(middle - waves * length);
    };
    return std::abs(pair(0.75) - pair(0.25)) / 8;
}

} // namespace

std::optional<RoughnessProfile> RoughnessProfile::through(const FaceAdjacency& faces,
                                                          const SheetPoint& at, const Vec3& along,
                                                          double length) {
    RoughnessProfile profile;
    profile.step_ = length / profile_steps;
    profile.between_borders_ = true;
    const auto walk = [&](double side) {
        GeodesicTrace trace =
            walk_straight(faces, at, along * side, profile.step_, profile_reach * length, false);
        const auto away =
            std::find_if(trace.points.begin(), trace.points.end(), [&](const WalkPoint& point) {
                return point.normal.dot(trace.points.front().normal) <= 0;
            });
        if (!trace.ended || away != trace.points.end()) profile.between_borders_ = false;
        trace.points.erase(away, trace.points.end());
        return trace.points;
    };
    const std::vector<WalkPoint> behind = walk(-1), ahead = walk(1);
    if (behind.size() + ahead.size() < fewest_samples) return std::nullopt;
    profile.points_.assign(behind.rbegin(), behind.rend() - 1);
    profile.points_.insert(profile.points_.end(), ahead.begin(), ahead.end());
    profile.begin_ = -static_cast<double>(behind.size() - 1) * profile.step_;
    profile.heights_ = integrated(profile.points_, profile.step_);
    return profile;
}

bool RoughnessProfile::holds(double s) const {
    constexpr double rounding = 1e-9;
    const double at = (s - begin_) / step_;
    return at >= -rounding && at <= static_cast<double>(heights_.size() - 1) + rounding;
}

/// The cubic through the four samples around.
double RoughnessProfile::height(double s) const {
    const double at = (s - begin_) / step_;
    const auto last = static_cast<std::ptrdiff_t>(heights_.size()) - 4;
    const auto first =
        std::clamp(static_cast<std::ptrdiff_t>(std::floor(at)) - 1, std::ptrdiff_t{0}, last);
    const double t = at - static_cast<double>(first);
    const auto w = [&](int k) { return heights_[static_cast<std::size_t>(first + k)]; };
    return (w(3) * t * (t - 1) * (t - 2) - w(0) * (t - 1) * (t - 2) * (t - 3)) / 6 +
           (w(1) * t * (t - 2) * (t - 3) - w(2) * t * (t - 1) * (t - 3)) / 2;
}

SheetPoint RoughnessProfile::place(const FaceAdjacency& faces, double s) const {
    const double last = static_cast<double>(points_.size() - 1);
    const double number = std::clamp(std::round((s - begin_) / step_), 0.0, last);
    const auto i = static_cast<std::size_t>(number);
    const WalkPoint &before = points_[i == 0 ? 0 : i - 1], &here = points_[i];
    const WalkPoint& behind = points_[std::min(i + 1, points_.size() - 1)];
    const auto frame = faces.frame(here.at, behind.position - before.position);
    if (!frame) return here.at;
    return faces.moved(*frame, here.at, Vec2(s - begin_ - number * step_, 0)).value_or(here.at);
}

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

std::optional<WaveSection> narrow_wave_section(const FaceAdjacency& faces, const SheetPoint& at,
                                               const Vec3& along, bool crest, double length) {
    const auto profile = RoughnessProfile::through(faces, at, along, length);
    if (!profile || !profile->is_between_borders() || wave_at(*profile, 0, length))
        return std::nullopt;
    const double side = crest ? 1 : -1;
    const auto wave = deepest(*profile, side, length, narrow_wave_at);
    if (!wave || !(wave->depth * side > 0)) return std::nullopt;
    const double shorter = narrow_swing_at(*profile, wave->middle, 0.95 * wave->length);
    const double bound = std::abs(std::abs(shorter) - std::abs(wave->depth)) +
                         bend_at(*profile, wave->middle, wave->length);
    const SheetPoint place = profile->place(faces, wave->crest);
    return WaveSection{std::abs(wave->depth), wave->length, bound, place,
                       faces.evaluate(place, 0)->position()};
}

} // namespace keiko
