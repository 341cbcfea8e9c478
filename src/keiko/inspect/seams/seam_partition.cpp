#include "keiko/inspect/seams/seam_partition.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr int least_steps = 16;
constexpr int most_halvings = 48;
/// Largest number of places of one piece that are evaluated. The rest is judged as smooth.
constexpr int most_places = 4000;
/// degrees: angles this close on both sides of a threshold are not distinguished.
constexpr double indistinct = 1e-8;

/// True if an angle that is `a`, `m` and `b` at begin, middle and end of a step may pass
/// `threshold` between them, although none of the three lies beyond it.
bool may_pass(double threshold, double a, double m, double b) {
    const auto [low, high] = std::minmax({a, m, b});
    const double deviation = std::abs(m - (a + b) / 2);
    return (high <= threshold && high + deviation > threshold) ||
           (low > threshold && low - deviation <= threshold);
}

class Partition {
public:
    Partition(const SeamProbe& probe, std::uint32_t piece, const StretchLimits& limits)
        : probe_(probe), piece_(piece), limits_(limits) {}

    std::vector<SeamPart> run() {
        const std::vector<SeamStep> steps = probe_.steps(least_steps);
        SeamPoint before = probe_.at(steps.front().t, steps.front().s);
        add(kind(before), before);
        for (std::size_t i = 1; i < steps.size(); ++i) {
            const SeamPoint after = probe_.at(steps[i].t, steps[i].s);
            refine(before, after, 0);
            before = after;
        }
        drop_empty();
        // Quadrature is exact where the parametrisation is uniform; chords are at most as long as
        // the curve.
        for (SeamPart& part : parts_)
            part.length = std::max(part.length, probe_.part(part.begin, part.end).length());
        return std::move(parts_);
    }

private:
    std::optional<SeamClass> kind(const SeamPoint& point) const {
        return class_of(point, limits_.feature_angle);
    }

    /// True if no angle between the points of a step lies beyond a threshold that none of them
    /// passes.
    bool is_plain(const SeamPoint& a, const SeamPoint& m, const SeamPoint& b) const {
        const double length = (b.place - a.place).length();
        if (!a.angle || !m.angle || !b.angle) return !m.angle || length < limits_.negligible;
        if (length < limits_.negligible / 8) return true;
        return !may_pass(limits_.feature_angle, *a.angle, *m.angle, *b.angle) &&
               !may_pass(fold_angle, *a.angle, *m.angle, *b.angle);
    }

    void refine(const SeamPoint& a, const SeamPoint& b, int halvings) {
        check_stop();
        const double t = (a.t + b.t) / 2;
        const bool apart = t != a.t && t != b.t && halvings < most_halvings;
        const bool distinct = (b.place - a.place).length() > class_change_bound;
        if (!apart || (!distinct && kind(a) != kind(b))) {
            add(kind(a), a), add(kind(b), b);
            return;
        }
        if (++places_ > most_places) {
            add(SeamClass::smooth, b);
            return;
        }
        if (a.angle && b.angle && kind(a) != kind(b) &&
            std::abs(*a.angle - *b.angle) <= indistinct) {
            add(std::min(kind(a), kind(b)), b);
            return;
        }
        const SeamPoint m = probe_.at(t, (a.s + b.s) / 2);
        const std::optional<SeamClass> first = kind(a) ? kind(a) : kind(m);
        const std::optional<SeamClass> last = kind(b) ? kind(b) : kind(m);
        const bool one_class = first == last && (!kind(m) || kind(m) == first);
        if (one_class && is_plain(a, m, b)) {
            add(first, b);
            return;
        }
        refine(a, m, halvings + 1), refine(m, b, halvings + 1);
    }

    /// Continues to a point of a class, or of none if it belongs to its neighbour.
    void add(std::optional<SeamClass> known, const SeamPoint& to) {
        if (parts_.empty()) {
            parts_.push_back({piece_, known.value_or(SeamClass::smooth), to, to, 0});
            is_known_ = known.has_value();
        } else if (!known || !is_known_ || *known == parts_.back().kind) {
            if (known && !is_known_) parts_.back().kind = *known, is_known_ = true;
            const double step = (to.place - parts_.back().end.place).length();
            parts_.back().length += step;
            if (!to.angle) parts_.back().unknown += step;
            parts_.back().end = to;
        } else {
            // Angles that are not distinguished belong to the part before, up to the last such
            // place.
            const SeamPoint last = parts_.back().end;
            const bool located = (to.place - last.place).length() <= class_change_bound;
            parts_.push_back({piece_, *known, located ? to : last, to, 0});
        }
    }

    /// Parts without a length come from changes at the very ends of a piece.
    void drop_empty() {
        if (parts_.size() < 2) return;
        const SeamPart first = parts_.front();
        std::erase_if(parts_, [](const SeamPart& part) { return !(part.begin.t < part.end.t); });
        if (parts_.empty()) parts_.push_back(first);
    }

    const SeamProbe& probe_;
    std::uint32_t piece_;
    const StretchLimits& limits_;
    std::vector<SeamPart> parts_;
    int places_ = 0;        ///< evaluated so far
    bool is_known_ = false; ///< the class of the last part
};

} // namespace

std::vector<SeamPart> partition_seam(const SeamProbe& probe, std::uint32_t piece,
                                     const StretchLimits& limits) {
    return Partition(probe, piece, limits).run();
}

} // namespace keiko
