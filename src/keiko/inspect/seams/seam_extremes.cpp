#include "keiko/inspect/seams/seam_extremes.h"

#include "keiko/base/job.h"
#include "keiko/math/golden_section.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr std::size_t most_halvings = 200;
/// A peak flatter than this share of the tolerance is a plateau, not worth polishing.
constexpr double polish_share = 1e-6;

struct Cell {
    SeamPoint begin, middle, end;
};

double middle(const SeamPoint& a, const SeamPoint& b) {
    return (a.t + b.t) / 2;
}

SeamPoint halfway(const SeamProbe& probe, const SeamPoint& a, const SeamPoint& b) {
    return probe.at(middle(a, b), (a.s + b.s) / 2);
}

std::vector<Cell> first_cells(const SeamProbe& probe, int count) {
    std::vector<Cell> cells;
    const std::vector<SeamStep> steps = probe.steps(count);
    SeamPoint before = probe.at(steps.front().t, steps.front().s);
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const SeamPoint after = probe.at(steps[i].t, steps[i].s);
        cells.push_back({before, halfway(probe, before, after), after});
        before = after;
    }
    if (cells.empty()) cells.push_back({before, before, before});
    return cells;
}

/// The largest of the three values, and an upper bound of the cell's values. Where one of them is
/// not defined, as at a pole, the others tell how they change.
struct Reach {
    double best = -HUGE_VAL, upper = -HUGE_VAL;
    SeamPoint point;
};

Reach reach(const Cell& cell, const SeamQuantity& quantity) {
    Reach result;
    std::array<double, 3> values{};
    std::size_t known = 0;
    for (const SeamPoint* p : {&cell.begin, &cell.middle, &cell.end}) {
        const std::optional<double> value = quantity(*p);
        if (!value || !std::isfinite(*value)) continue;
        values[known++] = *value;
        if (*value > result.best) result.best = *value, result.point = *p;
    }
    result.upper = result.best;
    if (known == 3) result.upper += std::abs(values[1] - (values[0] + values[2]) / 2);
    if (known == 2) result.upper += std::abs(values[1] - values[0]);
    return result;
}

class ExtremeSearch {
public:
    ExtremeSearch(const SeamProbe& probe, std::vector<Cell>& cells, const SeamQuestion& question)
        : probe_(probe), cells_(cells), question_(question) {
        for (const Cell& cell : cells_) note(cell);
    }

    std::optional<SeamExtreme> run() {
        if (!std::isfinite(best_.best)) return std::nullopt;
        const std::size_t most_cells = cells_.size() + most_halvings;
        while (cells_.size() < most_cells) {
            check_stop();
            const std::size_t most = most_promising();
            if (reaches_[most].upper <= best_.best + question_.tolerance) break;
            if (!split(most)) break;
        }
        const double upper = reaches_[most_promising()].upper;
        if (upper - best_.best > question_.tolerance * polish_share) polish();
        return SeamExtreme{best_.best, std::max(0.0, upper - best_.best), best_.point};
    }

private:
    void note(const Cell& cell) {
        reaches_.push_back(reach(cell, question_.quantity));
        if (reaches_.back().best > best_.best) best_ = reaches_.back();
    }

    std::size_t most_promising() const {
        const auto most =
            std::max_element(reaches_.begin(), reaches_.end(),
                             [](const Reach& a, const Reach& b) { return a.upper < b.upper; });
        return static_cast<std::size_t>(most - reaches_.begin());
    }

    bool split(std::size_t index) {
        const Cell whole = cells_[index];
        const double t = middle(whole.begin, whole.middle);
        if (t == whole.begin.t || t == whole.middle.t) return false;
        cells_[index] = {whole.begin, halfway(probe_, whole.begin, whole.middle), whole.middle};
        cells_.push_back({whole.middle, halfway(probe_, whole.middle, whole.end), whole.end});
        note(cells_[index]);
        reaches_[index] = reaches_.back();
        reaches_.pop_back();
        note(cells_.back());
        return true;
    }

    /// Golden-section steps around the best point between its neighbours.
    void polish();

    const SeamProbe& probe_;
    std::vector<Cell>& cells_;
    const SeamQuestion& question_;
    std::vector<Reach> reaches_;
    Reach best_;
};

void ExtremeSearch::polish() {
    if (best_.point.t == probe_.begin() || best_.point.t == probe_.end()) return;
    double low = probe_.begin(), high = probe_.end();
    for (const Cell& cell : cells_)
        for (const SeamPoint* p : {&cell.begin, &cell.middle, &cell.end}) {
            if (p->t < best_.point.t) low = std::max(low, p->t);
            if (p->t > best_.point.t) high = std::min(high, p->t);
        }
    // A value near its peak is flat: 1e-8 of the width decides its last digit.
    const double enough = (high - low) * 1e-8;
    const auto negated = [&](double t) {
        const SeamPoint point = probe_.at(t, best_.point.s);
        const double value = question_.quantity(point).value_or(-HUGE_VAL);
        if (value > best_.best) best_.best = value, best_.point = point;
        return -value;
    };
    golden_section_minimum(negated, low, {best_.point.t, -best_.best}, high, enough);
}

} // namespace

std::vector<std::optional<SeamExtreme>> seam_extremes(const SeamProbe& probe,
                                                      const std::vector<SeamQuestion>& questions,
                                                      int cells) {
    std::vector<Cell> shared = first_cells(probe, cells);
    std::vector<std::optional<SeamExtreme>> result;
    result.reserve(questions.size());
    for (const SeamQuestion& question : questions)
        result.push_back(ExtremeSearch(probe, shared, question).run());
    return result;
}

} // namespace keiko
