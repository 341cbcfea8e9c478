#include "keiko/inspect/seams/profile_samples.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr int least_steps = 8;          // of a piece, as the search for extremes has
constexpr std::size_t most_added = 200; // to a piece, as the search halves
constexpr int most_rounds = 12;         // a step of the thousandth part, from an eighth

SeamPoint halfway(const SeamProbe& probe, const SeamPoint& a, const SeamPoint& b) {
    return probe.at((a.t + b.t) / 2, (a.s + b.s) / 2);
}

bool leaves_chord(const SampledQuantity& quantity, const SeamPoint& a, const SeamPoint& middle,
                  const SeamPoint& b) {
    const auto x = quantity.value(a), y = quantity.value(middle), z = quantity.value(b);
    if (!x || !y || !z) return x.has_value() != z.has_value() || x.has_value() != y.has_value();
    return std::abs(*y - (*x + *z) / 2) > quantity.tolerance;
}

bool crosses_limit(const SampledQuantity& quantity, const SeamPoint& a, const SeamPoint& b) {
    const auto x = quantity.value(a), y = quantity.value(b);
    if (!quantity.limit || !x || !y) return false;
    return (*x > *quantity.limit) != (*y > *quantity.limit);
}

/// Halves steps of one piece in rounds, each step of a round once.
class Refinement {
public:
    Refinement(const SeamProbe& probe, std::span<const SampledQuantity> quantities, double shortest)
        : probe_(probe), quantities_(quantities), shortest_(shortest) {}

    std::vector<SeamPoint> run(std::vector<SeamPoint> samples) {
        std::vector<bool> open(samples.size(), true);
        for (int round = 0; round < most_rounds && added_ < most_added; ++round) {
            check_stop();
            std::vector<SeamPoint> finer{samples.front()};
            std::vector<bool> finer_open{true};
            for (std::size_t i = 1; i < samples.size(); ++i) {
                const bool is_halved = open[i] && halve(samples[i - 1], samples[i], finer);
                finer_open.resize(finer.size(), true);
                finer.push_back(samples[i]);
                finer_open.push_back(is_halved);
            }
            if (finer.size() == samples.size()) break;
            samples = std::move(finer), open = std::move(finer_open);
        }
        return samples;
    }

private:
    /// Adds the middle of a step if it is needed.
    bool halve(const SeamPoint& a, const SeamPoint& b, std::vector<SeamPoint>& samples) {
        if (added_ == most_added || !(a.t < (a.t + b.t) / 2 && (a.t + b.t) / 2 < b.t)) return false;
        const SeamPoint middle = halfway(probe_, a, b);
        const auto is_needed = [&](const SampledQuantity& quantity) {
            return leaves_chord(quantity, a, middle, b) ||
                   (crosses_limit(quantity, a, b) && (b.place - a.place).length() > shortest_);
        };
        if (!std::any_of(quantities_.begin(), quantities_.end(), is_needed)) return false;
        samples.push_back(middle);
        ++added_;
        return true;
    }

    const SeamProbe& probe_;
    std::span<const SampledQuantity> quantities_;
    double shortest_;
    std::size_t added_ = 0;
};

} // namespace

std::vector<SeamPoint> first_samples(const SeamProbe& probe, const StretchExtremes& extremes) {
    std::vector<SeamPoint> samples;
    for (const SeamStep& step : probe.steps(least_steps))
        samples.push_back(probe.at(step.t, step.s));
    if (samples.size() == 1) samples.push_back(probe.at(probe.end()));
    for (const auto* extreme :
         {&extremes.gap, &extremes.angle, &extremes.curvature, &extremes.slope})
        if (*extreme) samples.push_back((*extreme)->point);
    const auto before = [](const SeamPoint& a, const SeamPoint& b) { return a.t < b.t; };
    const auto same = [](const SeamPoint& a, const SeamPoint& b) { return a.t == b.t; };
    std::stable_sort(samples.begin(), samples.end(), before);
    samples.erase(std::unique(samples.begin(), samples.end(), same), samples.end());
    return samples;
}

std::vector<SeamPoint> refined_samples(const SeamProbe& probe, std::vector<SeamPoint> samples,
                                       std::span<const SampledQuantity> quantities,
                                       double shortest) {
    return Refinement(probe, quantities, shortest).run(std::move(samples));
}

} // namespace keiko
