#include "keiko/inspect/joints/joint_extremes.h"

#include "keiko/math/golden_section.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

using Quantity = double (*)(const JointSection&);

double gap_of(const JointSection& s) {
    return s.gap;
}
double minus_gap_of(const JointSection& s) {
    return -s.gap;
}
double flush_of(const JointSection& s) {
    return s.flush;
}
double minus_flush_of(const JointSection& s) {
    return -s.flush;
}
double radius_of(const JointSection& s) {
    return s.least_radius();
}

class ExtremeSearch {
public:
    ExtremeSearch(const JointRuns& runs, std::span<const JointStation> stations, std::size_t other)
        : runs_(runs), stations_(stations), other_(other) {}

    /// The section of the least quantity; requires a station with a section.
    JointSection least(Quantity quantity) const {
        std::size_t at = stations_.size();
        for (std::size_t i = 0; i < stations_.size(); ++i)
            if (stations_[i].section &&
                (at == stations_.size() || value(quantity, i) < value(quantity, at)))
                at = i;
        JointSection best = *stations_[at].section;
        if (at > 0) search(quantity, at - 1, at, best);
        if (at + 1 < stations_.size()) search(quantity, at, at + 1, best);
        return best;
    }

    /// The most that a parabola through three neighbours leaves its chords by.
    double hidden(Quantity quantity) const {
        double most = 0;
        for (std::size_t i = 1; i + 1 < stations_.size(); ++i) {
            const JointStation &before = stations_[i - 1], &after = stations_[i + 1];
            const double span = after.along - before.along;
            if (!before.section || !stations_[i].section || !after.section || !(span > 0)) continue;
            const double share = (stations_[i].along - before.along) / span;
            const double chord =
                quantity(*before.section) * (1 - share) + quantity(*after.section) * share;
            most = std::max(most, std::abs(value(quantity, i) - chord) / 4);
        }
        return most;
    }

private:
    double value(Quantity quantity, std::size_t i) const { return quantity(*stations_[i].section); }

    /// Searches between two neighbours on one border.
    void search(Quantity quantity, std::size_t from, std::size_t to, JointSection& best) const {
        const JointStation &a = stations_[from], &b = stations_[to];
        if (a.border != b.border || !a.section || !b.section || a.t == b.t) return;
        const auto [low, high] = std::minmax(a.t, b.t);
        const auto at = [&](double t) { return runs_.section(a.border, t, other_); };
        const auto of = [&](double t) {
            const auto section = at(t);
            return section ? quantity(*section) : std::numeric_limits<double>::infinity();
        };
        constexpr double enough = 1e-5; // of the interval: the value is stationary there
        const double t = golden_section_minimum(of, low, high, enough * (high - low)).at;
        const auto section = at(t);
        if (section && quantity(*section) < quantity(best)) best = *section;
    }

    const JointRuns& runs_;
    std::span<const JointStation> stations_;
    std::size_t other_;
};

} // namespace

std::optional<JointExtremes> joint_extremes(const JointRuns& runs,
                                            std::span<const JointStation> stations,
                                            std::size_t other) {
    bool any = false;
    for (const JointStation& station : stations) any = any || station.section;
    if (!any) return std::nullopt;
    const ExtremeSearch search(runs, stations, other);
    JointExtremes found;
    found.widest = search.least(minus_gap_of), found.narrowest = search.least(gap_of);
    found.proudest = search.least(minus_flush_of), found.deepest = search.least(flush_of);
    found.sharpest = search.least(radius_of);
    found.hidden_gap = search.hidden(gap_of), found.hidden_flush = search.hidden(flush_of);
    found.hidden_radius = search.hidden(radius_of);
    return found;
}

} // namespace keiko
