#include "keiko/inspect/seams/seam_steps.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Halvings of a course's first interval: unequal weights crowd a border's length into as small a
/// share of its parameter as two to the minus that.
constexpr int most_halvings = 60;

/// Moves a step by up to a tenth in either direction, so that no regular wave has its zeros at all
/// of them: the fractions of the golden section's multiples.
double uneven(int i) {
    constexpr double golden = 0.6180339887498949, most = 0.1;
    return most * (2 * std::fmod(i * golden, 1.0) - 1);
}

/// Share of a polynomial's parameter at a share of its steps, which are shorter towards its ends,
/// as its waves may be.
double polynomial_share(double steps) {
    return (1 - std::cos(std::numbers::pi * steps)) / 2;
}

/// Inverse of polynomial_share.
double share_of_steps(double share) {
    return 2 / std::numbers::pi * std::asin(std::sqrt(std::clamp(share, 0.0, 1.0)));
}

double between(double a, double b, double share) {
    return a + (b - a) * share;
}

/// Share of the way from a to b at which x lies; 0 if there is none.
double share_between(double a, double b, double x) {
    return b != a ? std::clamp((x - a) / (b - a), 0.0, 1.0) : 0;
}

/// Number of measures in which steps are even: the length, the parameters of both curves and the
/// paths in the parameters of both faces.
constexpr std::size_t measures = 5;

/// A place of a piece of a seam on which both sides are smooth.
struct PiecePlace {
    SeamStep step;
    std::array<double, measures> share{}; ///< 0 to 1 along the piece, by each
};

/// A sum of steps, and the measure by which the last of them count.
struct StepCount {
    double sum = 0;
    std::size_t measure = 0;
};

/// A piece of a seam on which both sides are smooth, by the courses of both. Places of one share
/// of the length face each other.
class SmoothPiece {
public:
    SmoothPiece(const SurfaceCurve& a, const SurfaceCurve& b, const SeamStep& from,
                const SeamStep& to)
        : degree_a_(a.degree_at((from.t + to.t) / 2)),
          degree_b_(b.degree_at((from.s + to.s) / 2)),
          a_(a, from.t, to.t, 2 * std::max(2, degree_a_)),
          b_(b, from.s, to.s, 2 * std::max(2, degree_b_)) {}

    double length() const { return a_.length(); }

    /// Adds its steps, at least `least`, without its begin.
    void add_steps(int least, std::vector<SeamStep>& steps) const;

private:
    std::vector<PiecePlace> places() const;
    PiecePlace place(std::size_t i, std::size_t j, double share) const;
    std::vector<StepCount> count_steps(const std::vector<PiecePlace>& places, int least) const;

    int degree_a_, degree_b_;
    SideCourse a_, b_;
};

/// The place at a share of the length, after the i-th place of side a and the j-th one of side b.
PiecePlace SmoothPiece::place(std::size_t i, std::size_t j, double share) const {
    const auto on = [share](const SideCourse& course, std::size_t k) {
        const auto& places = course.places();
        SideCourse::Place at = places[k];
        if (k + 1 == places.size()) return at;
        const double x = share_between(course.share(k), course.share(k + 1), share);
        at.t = between(at.t, places[k + 1].t, x);
        at.path = between(at.path, places[k + 1].path, x);
        return at;
    };
    const auto share_of_course = [](const SideCourse& course, double x,
                                    double SideCourse::Place::*of) {
        return share_between(course.places().front().*of, course.places().back().*of, x);
    };
    const SideCourse::Place a = on(a_, i), b = on(b_, j);
    using Place = SideCourse::Place;
    return {{a.t, b.t},
            {share, share_of_course(a_, a.t, &Place::t), share_of_course(b_, b.t, &Place::t),
             share_of_course(a_, a.path, &Place::path), share_of_course(b_, b.path, &Place::path)}};
}

/// The places of both courses, each with the one that faces it.
std::vector<PiecePlace> SmoothPiece::places() const {
    const std::size_t last_a = a_.places().size() - 1, last_b = b_.places().size() - 1;
    std::size_t i = 0, j = 0;
    std::vector<PiecePlace> result{place(0, 0, 0)};
    while (i < last_a || j < last_b) {
        const double next_a = i < last_a ? a_.share(i + 1) : HUGE_VAL;
        const double next_b = j < last_b ? b_.share(j + 1) : HUGE_VAL;
        const double next = std::min(next_a, next_b);
        if (next_a <= next) ++i;
        if (next_b <= next) ++j;
        result.push_back(place(i, j, next));
    }
    return result;
}

/// How many steps there are up to each place, by the measure that needs the most from the place
/// before.
std::vector<StepCount> SmoothPiece::count_steps(const std::vector<PiecePlace>& places,
                                                int least) const {
    const std::array<int, measures> counts{std::max({2, degree_a_, degree_b_, least}), degree_a_,
                                           degree_b_, degree_a_, degree_b_};
    std::vector<StepCount> sums{{}};
    for (std::size_t j = 1; j < places.size(); ++j) {
        StepCount most{-1, 0};
        for (std::size_t k = 0; k < measures; ++k) {
            const double count = counts[k] * (share_of_steps(places[j].share[k]) -
                                              share_of_steps(places[j - 1].share[k]));
            if (count > most.sum) most = {count, k};
        }
        sums.push_back({sums.back().sum + most.sum, most.measure});
    }
    return sums;
}

void SmoothPiece::add_steps(int least, std::vector<SeamStep>& steps) const {
    const std::vector<PiecePlace> places = this->places();
    const std::vector<StepCount> sums = count_steps(places, least);
    const int count = static_cast<int>(std::lround(sums.back().sum));
    std::size_t j = 1;
    for (int i = 1; i < count; ++i) {
        const double at = sums.back().sum * (i + uneven(i)) / count;
        while (j + 1 < sums.size() && sums[j].sum <= at) ++j;
        const std::size_t k = sums[j].measure;
        const double before = places[j - 1].share[k], after = places[j].share[k];
        const double in_steps = between(share_of_steps(before), share_of_steps(after),
                                        share_between(sums[j - 1].sum, sums[j].sum, at));
        const double x = share_between(before, after, polynomial_share(in_steps));
        const SeamStep &from = places[j - 1].step, &to = places[j].step;
        const SeamStep step{between(from.t, to.t, x), between(from.s, to.s, x)};
        if (step.t > steps.back().t && step.t < places.back().step.t) steps.push_back(step);
    }
    steps.push_back(places.back().step);
}

} // namespace

SideCourse::SideCourse(const SurfaceCurve& curve, double begin, double end, int least)
    : curve_(&curve) {
    std::vector<Place> first;
    for (int i = 0; i <= least; ++i) {
        Place next = place_at(i < least ? between(begin, end, double(i) / least) : end);
        add(next);
        first.push_back(places_.back());
    }
    Place most = first.back();
    most.length *= 2.0 / least, most.path *= 2.0 / least;
    places_.resize(1);
    for (std::size_t i = 1; i < first.size(); ++i) refine(first[i - 1], first[i], most, 0);
}

SideCourse::Place SideCourse::place_at(double t) const {
    return {t, curve_->at(t).position, curve_->parameters(t)};
}

void SideCourse::add(Place next) {
    if (!places_.empty()) {
        const Place& last = places_.back();
        next.length = last.length + (next.position - last.position).length();
        next.path = last.path + (next.parameters - last.parameters).length();
    }
    places_.push_back(next);
}

void SideCourse::refine(const Place& a, const Place& b, const Place& most, int halvings) {
    check_stop();
    const double t = (a.t + b.t) / 2;
    const bool is_far = (b.position - a.position).length() > most.length ||
                        (b.parameters - a.parameters).length() > most.path;
    if (!is_far || halvings == most_halvings || t == a.t || t == b.t) {
        add(b);
        return;
    }
    const Place middle = place_at(t);
    refine(a, middle, most, halvings + 1), refine(middle, b, most, halvings + 1);
}

double SideCourse::share(std::size_t place) const {
    if (place + 1 == places_.size()) return 1;
    if (!(length() > 0)) return double(place) / double(places_.size() - 1);
    return places_[place].length / length();
}

double SideCourse::share_at(double t) const {
    const bool rises = places_.front().t < places_.back().t;
    const auto before = [&](const Place& p, double x) { return rises ? p.t < x : p.t > x; };
    const auto after = std::lower_bound(places_.begin() + 1, places_.end() - 1, t, before);
    const auto i = static_cast<std::size_t>(after - places_.begin());
    return between(share(i - 1), share(i), share_between(places_[i - 1].t, after->t, t));
}

double SideCourse::parameter_at(double share) const {
    std::size_t i = 1;
    while (i + 1 < places_.size() && this->share(i) < share) ++i;
    const double x = share_between(this->share(i - 1), this->share(i), share);
    return between(places_[i - 1].t, places_[i].t, x);
}

std::vector<SeamStep> seam_steps(const SurfaceCurve& a, const SurfaceCurve& b,
                                 const std::vector<SeamStep>& stops, int least) {
    constexpr double distinct = 1e-12; // share of the seam: changes of both sides at one place
    const double span = stops.back().t - stops.front().t;
    std::vector<SmoothPiece> pieces;
    SeamStep from = stops.front();
    double length = 0;
    for (const SeamStep& stop : stops) {
        if (!(stop.t - from.t > distinct * span)) continue;
        pieces.emplace_back(a, b, from, stop);
        length += pieces.back().length();
        from = stop;
    }
    std::vector<SeamStep> steps{stops.front()};
    for (const SmoothPiece& piece : pieces) {
        const double share = length > 0 ? piece.length() / length : 1;
        piece.add_steps(static_cast<int>(std::ceil(share * least)), steps);
    }
    if (steps.size() > 1) steps.back() = stops.back();
    return steps;
}

} // namespace keiko
