#include "keiko/fog/height_field.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

/// Angles of a wave over a place.
Vec2 angles(const Wave& wave, double x, double y) {
    const Vec2 k = wave.turn();
    return {k.x * x + degrees_to_radians(wave.phase.x), k.y * y + degrees_to_radians(wave.phase.y)};
}

} // namespace

Vec2 Wave::turn() const {
    return {2 * std::numbers::pi / wavelength.x, 2 * std::numbers::pi / wavelength.y};
}

double Wave::height(double x, double y) const {
    const Vec2 angle = angles(*this, x, y);
    return amplitude * std::sin(angle.x) * std::sin(angle.y);
}

Vec2 Wave::slopes(double x, double y) const {
    const Vec2 angle = angles(*this, x, y), k = turn();
    return {amplitude * k.x * std::cos(angle.x) * std::sin(angle.y),
            amplitude * k.y * std::sin(angle.x) * std::cos(angle.y)};
}

double HeightField::at(double x, double y) const {
    double z = height;
    for (const Wave& wave : waves) z += wave.height(x, y);
    return z;
}

Vec2 HeightField::slopes(double x, double y) const {
    Vec2 sum(0);
    for (const Wave& wave : waves) sum += wave.slopes(x, y);
    return sum;
}

namespace {

/// What of the segment is between the troughs and the crests of the waves, where it may cross.
ParameterInterval between_crests(const HeightField& field, const Segment& segment) {
    double reach = 0;
    for (const Wave& wave : field.waves) reach += std::abs(wave.amplitude);
    const double from = segment.a.z - field.height, rise = segment.b.z - segment.a.z;
    if (rise == 0) return std::abs(from) <= reach ? ParameterInterval{0, 1} : ParameterInterval{};
    const double a = (-reach - from) / rise, b = (reach - from) / rise;
    return {std::clamp(std::min(a, b), 0.0, 1.0), std::clamp(std::max(a, b), 0.0, 1.0)};
}

/// Finds the zeros of the height over the surface along a segment by halving: the second
/// derivative is bounded, so that a piece is proved to have none, or at most one.
class CrossingFinder {
public:
    CrossingFinder(const HeightField& field, const Segment& segment)
        : field_(field), segment_(segment), way_(segment.b - segment.a) {
        for (const Wave& wave : field.waves) {
            const Vec2 k = wave.turn();
            const double turn = std::abs(k.x * way_.x) + std::abs(k.y * way_.y);
            bend_ += std::abs(wave.amplitude) * turn * turn;
        }
    }

    void search(double a, double fa, double b, double fb) {
        const double length = b - a, sag = bend_ * length * length / 8;
        if (fa > sag && fb > sag) return;
        if (fa < -sag && fb < -sag) return;
        if (std::abs(fb - fa) > bend_ * length * length || sag < least || --pieces_left_ < 0) {
            // Monotone, or as good as straight.
            if ((fa < 0) != (fb < 0)) found_.push_back(root(a, fa, b));
            return;
        }
        const double middle = (a + b) / 2, f = value(middle);
        search(a, fa, middle, f);
        search(middle, f, b, fb);
    }

    double value(double t) const { return field_.above(segment_.at(t)); }
    std::vector<double> found() && { return std::move(found_); }

private:
    static constexpr double least = 1e-9; ///< mm

    double slope(double t) const {
        const Vec3 p = segment_.at(t);
        const Vec2 s = field_.slopes(p.x, p.y);
        return way_.z - s.x * way_.x - s.y * way_.y;
    }
    /// Newton's method, kept inside by halving.
    double root(double a, double fa, double b) const {
        double t = (a + b) / 2;
        for (int i = 0; i < 100 && b - a > 1e-16; ++i) {
            const double f = value(t);
            ((f < 0) == (fa < 0) ? a : b) = t;
            const double next = t - f / slope(t);
            if (next == t) break;
            t = next > a && next < b ? next : (a + b) / 2;
        }
        return t;
    }

    const HeightField& field_;
    const Segment& segment_;
    Vec3 way_;
    double bend_ = 0; ///< bound of the second derivative
    /// A segment that lies in the surface is not searched for ever.
    int pieces_left_ = 100000;
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
    CrossingFinder finder(field, segment);
    finder.search(part.begin, finder.value(part.begin), part.end, finder.value(part.end));
    return std::move(finder).found();
}

std::vector<Wave> noise_waves(double amplitude, double wavelength) {
    // Lengths and phases in the golden ratio never fall into step.
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

} // namespace keiko
