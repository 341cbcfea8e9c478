#include "keiko/inspect/seam_partition.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr int least_steps = 8;
constexpr int most_halvings = 48;

/// Whether an angle that is `a`, `m` and `b` at begin, middle and end of a step may pass
/// `threshold` between them, although none of the three lies beyond it.
bool may_pass(double threshold, double a, double m, double b) {
    const auto [low, high] = std::minmax({a, m, b});
    const double deviation = std::abs(m - (a + b) / 2);
    return (high <= threshold && high + deviation > threshold) ||
           (low > threshold && low - deviation <= threshold);
}

class Partition {
public:
    Partition(const SeamProbe& probe, std::uint32_t piece, const PartitionLimits& limits)
        : probe_(probe), piece_(piece), limits_(limits) {}

    std::vector<SeamPart> run() {
        const std::vector<double> steps = probe_.steps(least_steps);
        SeamPoint before = probe_.at(steps.front());
        add(kind(before), before);
        for (std::size_t i = 1; i < steps.size(); ++i) {
            const SeamPoint after = probe_.at(steps[i]);
            refine(before, after, 0);
            before = after;
        }
        for (SeamPart& part : parts_) part.length = probe_.part(part.begin, part.end).length();
        return std::move(parts_);
    }

private:
    std::optional<SeamClass> kind(const SeamPoint& point) const {
        return class_of(point, limits_.feature_angle);
    }

    /// Whether no angle between the points of a step lies beyond a threshold that none of them
    /// passes.
    bool is_plain(const SeamPoint& a, const SeamPoint& m, const SeamPoint& b) const {
        if (!a.angle || !m.angle || !b.angle) return true;
        if ((b.place - a.place).length() < limits_.negligible / 8) return true;
        return !may_pass(limits_.feature_angle, *a.angle, *m.angle, *b.angle) &&
               !may_pass(fold_angle, *a.angle, *m.angle, *b.angle);
    }

    void refine(const SeamPoint& a, const SeamPoint& b, int halvings) {
        const double t = (a.t + b.t) / 2;
        const bool apart = t != a.t && t != b.t && halvings < most_halvings;
        const bool distinct = (b.place - a.place).length() > class_change_bound;
        if (!apart || (!distinct && kind(a) != kind(b))) {
            add(kind(a), a), add(kind(b), b);
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

    /// Goes on to a point in a class, or in none where it belongs to whatever is beside it.
    void add(std::optional<SeamClass> known, const SeamPoint& to) {
        if (parts_.empty()) {
            parts_.push_back({piece_, known.value_or(SeamClass::smooth), to, to, 0});
            is_known_ = known.has_value();
        } else if (!known || !is_known_ || *known == parts_.back().kind) {
            if (known && !is_known_) parts_.back().kind = *known, is_known_ = true;
            parts_.back().end = to;
        } else {
            parts_.push_back({piece_, *known, parts_.back().end, to, 0});
        }
    }

    const SeamProbe& probe_;
    std::uint32_t piece_;
    const PartitionLimits& limits_;
    std::vector<SeamPart> parts_;
    bool is_known_ = false; ///< the class of the last part
};

} // namespace

std::vector<SeamPart> partition_seam(const SeamProbe& probe, std::uint32_t piece,
                                     const PartitionLimits& limits) {
    return Partition(probe, piece, limits).run();
}

} // namespace keiko
