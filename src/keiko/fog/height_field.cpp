#include "keiko/fog/height_field.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

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

/// A term -amplitude cos(phase + turn t) of the height over the surface along a segment.
struct Ripple {
    double amplitude, phase, turn;
};

/// Of a product of sines two cosines.
std::vector<Ripple> ripples_along(const HeightField& field, const Segment& segment) {
    const Vec3 way = segment.b - segment.a;
    std::vector<Ripple> ripples;
    for (const Wave& wave : field.waves) {
        const Vec2 k = wave.turn(), start = angles(wave, segment.a.x, segment.a.y);
        const double x = k.x * way.x, y = k.y * way.y;
        ripples.push_back({wave.amplitude / 2, start.x - start.y, x - y});
        ripples.push_back({-wave.amplitude / 2, start.x + start.y, x + y});
    }
    return ripples;
}

/// The ripples at t, t + step, t + 2 step ..., by cos(a + d) = 2 cos d cos a - cos(a - d).
class RippleWalk {
public:
    RippleWalk(std::span<const Ripple> ripples, double begin, double step)
        : ripples_(ripples), begin_(begin), step_(step) {
        for (const Ripple& r : ripples) twice_.push_back(2 * std::cos(r.turn * step));
        here_.resize(ripples.size()), before_.resize(ripples.size());
    }

    /// The sum of the ripples at the next place.
    double next() {
        constexpr int most = 64; // before rounding has grown
        if (taken_ % most == 0) start(begin_ + taken_ * step_);
        ++taken_;
        double sum = 0;
        for (std::size_t i = 0; i < ripples_.size(); ++i) {
            sum += ripples_[i].amplitude * here_[i];
            const double after = twice_[i] * here_[i] - before_[i];
            before_[i] = here_[i], here_[i] = after;
        }
        return -sum;
    }

private:
    void start(double t) {
        for (std::size_t i = 0; i < ripples_.size(); ++i) {
            const Ripple& r = ripples_[i];
            here_[i] = std::cos(r.phase + r.turn * t);
            before_[i] = std::cos(r.phase + r.turn * (t - step_));
        }
    }

    std::span<const Ripple> ripples_;
    double begin_, step_;
    int taken_ = 0;
    std::vector<double> twice_, here_, before_;
};

/// Finds the zeros of the height over the surface along a segment by halving: the second
/// derivative is bounded, so that a piece is proved to have none, or at most one.
class CrossingFinder {
public:
    CrossingFinder(const HeightField& field, const Segment& segment)
        : start_(segment.a.z - field.height),
          rise_(segment.b.z - segment.a.z),
          ripples_(ripples_along(field, segment)) {
        for (const Ripple& r : ripples_) {
            bend_ += std::abs(r.amplitude) * r.turn * r.turn;
            fastest_ = std::max(fastest_, std::abs(r.turn));
        }
    }

    /// Steps short for all ripples, most of which are proved to have no zero by their ends.
    void search(const ParameterInterval& part) {
        constexpr double step_turn = std::numbers::pi / 8;
        const double steps = std::clamp(std::ceil(fastest_ * part.length() / step_turn), 1.0, 1e5);
        const int count = static_cast<int>(steps);
        const double step = part.length() / steps;
        RippleWalk walk(ripples_, part.begin, step);
        double a = part.begin, fa = straight(a) + walk.next();
        for (int i = 1; i <= count; ++i) {
            const double b = i == count ? part.end : part.begin + i * step;
            const double fb = straight(b) + walk.next();
            search(a, fa, b, fb);
            a = b, fa = fb;
        }
    }

    std::vector<double> found() && { return std::move(found_); }

private:
    static constexpr double least = 1e-9; ///< mm

    void search(double a, double fa, double b, double fb) {
        const double length = b - a, sag = bend_ * length * length / 8;
        if (fa > sag && fb > sag) return;
        if (fa < -sag && fb < -sag) return;
        if (std::abs(fb - fa) > bend_ * length * length || sag < least || --pieces_left_ < 0) {
            // Monotone, or as good as straight.
            if ((fa < 0) != (fb < 0)) found_.push_back(root(a, fa, b, fb));
            return;
        }
        const double middle = (a + b) / 2, f = height(middle).value;
        search(a, fa, middle, f);
        search(middle, f, b, fb);
    }

    double straight(double t) const { return start_ + rise_ * t; }

    struct Height {
        double value, slope;
    };
    Height height(double t) const {
        Height h{straight(t), rise_};
        for (const Ripple& r : ripples_) {
            const double angle = r.phase + r.turn * t;
            h.value -= r.amplitude * std::cos(angle);
            h.slope += r.amplitude * r.turn * std::sin(angle);
        }
        return h;
    }
    /// Newton's method, kept inside by halving.
    double root(double a, double fa, double b, double fb) const {
        constexpr double narrow = 1e-15;
        double t = a + (b - a) * (fa / (fa - fb));
        for (int i = 0; i < 100 && b - a > narrow; ++i) {
            const Height h = height(t);
            ((h.value < 0) == (fa < 0) ? a : b) = t;
            const double next = t - h.value / h.slope;
            if (std::abs(next - t) <= narrow) break;
            t = next > a && next < b ? next : (a + b) / 2;
        }
        return t;
    }

    double start_, rise_; ///< mm, over the middle of the waves
    std::vector<Ripple> ripples_;
    double bend_ = 0; ///< bound of the second derivative
    double fastest_ = 0;
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
    finder.search(part);
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
