#include "keiko/light/fog/height_field.h"

#include "keiko/base/job.h"
#include "keiko/math/sincos_2pi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

/// Sines of two angles in turns.
std::array<double, 2> sines_of(const Vec2& turns) {
    const std::array both{turns.x, turns.y};
    std::array<double, 2> cosines{}, sines{};
    sincos_2pi(both, cosines, sines);
    return sines;
}

} // namespace

Vec2 Wave::turns(double x, double y) const {
    return {x / wavelength.x + phase.x / 360, y / wavelength.y + phase.y / 360};
}

double Wave::height(double x, double y) const {
    const auto [sine_x, sine_y] = sines_of(turns(x, y));
    return amplitude * sine_x * sine_y;
}

double HeightField::at(double x, double y) const {
    double z = height;
    for (const Wave& wave : waves) z += wave.height(x, y);
    return z;
}

namespace {

/// The part of the segment between the troughs and the crests of the waves, where it may cross the
/// surface.
ParameterInterval between_crests(const HeightField& field, const Segment& segment) {
    double reach = 0;
    for (const Wave& wave : field.waves) reach += std::abs(wave.amplitude);
    const double from = segment.a.z - field.height, rise = segment.b.z - segment.a.z;
    if (rise == 0) return std::abs(from) <= reach ? ParameterInterval{0, 1} : ParameterInterval{};
    const double a = (-reach - from) / rise, b = (reach - from) / rise;
    return {std::clamp(std::min(a, b), 0.0, 1.0), std::clamp(std::max(a, b), 0.0, 1.0)};
}

/// Length of the segment in units of its shortest waves.
double waves_along(const HeightField& field, const Segment& segment) {
    const Vec3 way = segment.b - segment.a;
    double most = 0;
    for (const Wave& wave : field.waves)
        most = std::max(most,
                        std::abs(way.x / wave.wavelength.x) + std::abs(way.y / wave.wavelength.y));
    return most;
}

/// Steps along a segment from crossing to crossing. Height and slope at a place, with the bound of
/// the second derivative, prove a step free of crossings, or that it holds a single one.
class CrossingWalk {
public:
    CrossingWalk(const HeightField& field, const Segment& segment)
        : over_(field, segment), waves_along_(waves_along(field, segment)) {}

    std::vector<double> through(const ParameterInterval& part) && {
        Place here = at(part.begin);
        const double most_places = some_places + places_per_wave * waves_along_ * part.length();
        for (int i = 0; i < most_places && here.t < part.end; ++i) {
            if (i % places_between_checks == 0) check_stop();
            const Place next = at(std::min(here.t + stride(here), part.end));
            if (next.below() != here.below()) found_.push_back(root(here, next));
            here = next;
        }
        return std::move(found_);
    }

private:
    static constexpr double least = 1e-9; ///< mm
    /// Number of places after which a walk is given up. It takes about ten places a wave, and more
    /// than these only along a segment that lies in the surface.
    static constexpr double some_places = 10000, places_per_wave = 64;
    static constexpr int places_between_checks = 1024;

    struct Place {
        double t, height, slope;
        bool below() const { return height < 0; }
    };
    Place at(double t) const {
        const HeightAlong::Value over = over_.at(t);
        return {t, over.height, over.slope};
    }

    double stride(const Place& here) const {
        const double bend = over_.bend(), height = std::abs(here.height);
        const double away = here.below() ? -here.slope : here.slope;
        // Behind the only crossing, at the place certainly farthest from the surface.
        if (away < 0 && away * away > 2 * bend * height) return -away / bend;
        const double turn = std::sqrt(away * away + 2 * bend * height);
        const double free = away < 0 ? 2 * height / (turn - away) : (away + turn) / bend;
        // Between places this near to the surface, its distance is at most twice `least`.
        const double near = std::max(std::sqrt(8 * least / bend), 1e-15);
        return free > near ? free : near;
    }

    /// Newton's method, kept inside by halving.
    double root(Place a, const Place& b) const {
        constexpr double narrow = 1e-15;
        double low = a.t, high = b.t, t = a.t + (b.t - a.t) * (a.height / (a.height - b.height));
        for (int i = 0; i < 100 && high - low > narrow; ++i) {
            const Place here = at(t);
            (here.below() == a.below() ? low : high) = t;
            const double step = -here.height / here.slope, next = t + step;
            const bool inside = next > low && next < high;
            t = inside ? next : (low + high) / 2;
            // Largest possible next step.
            const double left = over_.bend() * step * step / (2 * std::abs(here.slope));
            if (inside && left <= narrow) break;
        }
        return t;
    }

    HeightAlong over_;
    double waves_along_;
    std::vector<double> found_;
};

} // namespace

std::vector<double> crossings(const HeightField& field, const Segment& segment) {
    const ParameterInterval part = between_crests(field, segment);
    if (field.waves.empty()) {
        const double t = part.begin;
        return t > 0 && t < 1 ? std::vector{t} : std::vector<double>{};
    }
    if (!(part.length() > 0)) return {};
    return CrossingWalk(field, segment).through(part);
}

std::vector<Wave> noise_waves(double amplitude, double wavelength) {
    // Lengths and phases in the golden ratio never come into phase.
    constexpr int count = 6;
    constexpr double golden = std::numbers::phi;
    std::vector<Wave> waves;
    double weight = 1, sum = 0, length = wavelength;
    for (int i = 0; i < count; ++i) {
        const double skew = i % 2 == 0 ? std::sqrt(golden) : 1 / std::sqrt(golden);
        waves.push_back(
            {weight, {length / skew, length * skew}, {90 * i * golden, 200 * i / golden}});
        sum += weight;
        weight /= golden, length /= golden;
    }
    for (Wave& wave : waves) wave.amplitude *= amplitude / sum;
    return waves;
}

HeightAlong::HeightAlong(const HeightField& field, const Segment& segment)
    : start_(segment.a.z - field.height),
      rise_(segment.b.z - segment.a.z),
      count_(2 * field.waves.size()),
      numbers_(6 * count_) {
    const Vec3 way = segment.b - segment.a;
    std::size_t next = 0;
    // A product of two sines is a difference of two cosines.
    const auto add = [&](double amplitude, double phase, double turn) {
        amplitudes()[next] = amplitude, phases()[next] = phase, turns()[next] = turn;
        const double k = 2 * std::numbers::pi * turn;
        bend_ += std::abs(amplitude) * k * k;
        ++next;
    };
    for (const Wave& wave : field.waves) {
        const Vec2 start = wave.turns(segment.a.x, segment.a.y);
        const double x = way.x / wave.wavelength.x, y = way.y / wave.wavelength.y;
        add(wave.amplitude / 2, start.x - start.y, x - y);
        add(-wave.amplitude / 2, start.x + start.y, x + y);
    }
}

HeightAlong::Value HeightAlong::at(double t) const {
    const auto places = column(3), cosines = column(4), sines = column(5);
    for (std::size_t i = 0; i < count_; ++i) places[i] = phases()[i] + turns()[i] * t;
    sincos_2pi(places, cosines, sines);
    double height = 0, slope = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        height += amplitudes()[i] * cosines[i];
        slope += amplitudes()[i] * turns()[i] * sines[i];
    }
    return {start_ + rise_ * t - height, rise_ + 2 * std::numbers::pi * slope};
}

} // namespace keiko
