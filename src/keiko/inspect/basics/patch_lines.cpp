#include "keiko/inspect/basics/patch_lines.h"

#include "keiko/base/job.h"
#include "keiko/math/bracketed_root.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

Triple<double> triple(const Vec3& w) {
    return {w.x, w.y, w.z};
}

/// Ends of arcs this close, in patch parameters, are one root found from two cells.
constexpr double same_end = 1e-9;
constexpr int most_halvings = 12; ///< of an arc

/// The part of a line in one cell.
struct Arc {
    LineCell cell;
    std::vector<LinePoint> points;
    double deviation = 0;
};

/// Points at which the level crosses the sides of a cell, found by the signs at its corners, in
/// their order around it.
std::vector<Vec2> crossings(const ZeroFunction& f, const Box2& box) {
    const std::array<Vec2, 4> corners{box.lower, Vec2(box.upper.x, box.lower.y), box.upper,
                                      Vec2(box.lower.x, box.upper.y)};
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) values[i] = f(corners[i]);
    std::vector<Vec2> found;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        if ((values[i] < 0) == (values[next] < 0)) continue;
        // Always from the same end, so that both neighbouring cells find the same bits.
        const bool forward = i < 2;
        const std::size_t a = forward ? i : next, b = forward ? next : i;
        found.push_back(f.root(corners[a], values[a], corners[b], values[b]));
    }
    return found;
}

/// The point of a proved cell's arc halfway between two others, along the parameter that the arc is
/// a graph over; nullopt if rounding leaves no sign change.
std::optional<Vec2> halfway(const ZeroFunction& f, const LineCell& cell, const Vec2& a,
                            const Vec2& b) {
    Vec2 low = cell.uv.lower, high = cell.uv.upper;
    if (cell.graph_over_v)
        low.y = high.y = (a.y + b.y) / 2;
    else
        low.x = high.x = (a.x + b.x) / 2;
    const double at_low = f(low), at_high = f(high);
    if ((at_low < 0) == (at_high < 0)) return std::nullopt;
    return f.root(low, at_low, high, at_high);
}

class ArcRefiner {
public:
    ArcRefiner(const ZeroFunction& f, Arc& arc, double chord_error)
        : f_(f), arc_(arc), chord_error_(chord_error) {}

    void run(const Vec2& from, const Vec2& to) {
        const LinePoint end = f_.point(to);
        arc_.points = {f_.point(from)};
        if (arc_.cell.proved) between(arc_.points.front(), end, most_halvings);
        arc_.points.push_back(end);
    }

private:
    void between(const LinePoint& a, const LinePoint& b, int halvings) {
        const std::optional<Vec2> uv = halfway(f_, arc_.cell, a.uv, b.uv);
        if (!uv) return;
        const LinePoint middle = f_.point(*uv);
        const Vec3 chord = b.place - a.place, off = middle.place - a.place;
        const double length = chord.length();
        const double bulge = length > 0 ? chord.cross(off).length() / length : off.length();
        if (bulge <= chord_error_ || halvings == 0) {
            arc_.points.push_back(middle);
            arc_.deviation = std::max(arc_.deviation, bulge);
            return;
        }
        between(a, middle, halvings - 1);
        arc_.points.push_back(middle);
        between(middle, b, halvings - 1);
    }

    const ZeroFunction& f_;
    Arc& arc_;
    double chord_error_;
};

bool same(const LinePoint& a, const LinePoint& b) {
    return (a.uv - b.uv).length() <= same_end;
}

/// Arcs that are not yet part of a line, found by the places of their ends.
class OpenArcs {
public:
    explicit OpenArcs(std::vector<Arc> arcs) : arcs_(std::move(arcs)), taken_(arcs_.size()) {
        for (std::size_t i = 0; i < arcs_.size(); ++i)
            for (const LinePoint& end : {arcs_[i].points.front(), arcs_[i].points.back()})
                ends_.emplace_back(key(end), i);
        std::sort(ends_.begin(), ends_.end());
    }

    /// Takes the first arc that is left.
    std::optional<Arc> next() {
        while (first_ < arcs_.size() && taken_[first_]) ++first_;
        if (first_ == arcs_.size()) return std::nullopt;
        return take(first_);
    }

    /// Takes the first arc that continues at a place, turned to begin there.
    std::optional<Arc> next_at(const LinePoint& place) {
        check_stop();
        std::size_t found = arcs_.size();
        const double at = key(place);
        auto end =
            std::lower_bound(ends_.begin(), ends_.end(), std::pair(at - reach, std::size_t{}));
        for (; end != ends_.end() && end->first <= at + reach; ++end)
            if (const std::size_t i = end->second; i < found && !taken_[i] && continues(i, place))
                found = i;
        if (found == arcs_.size()) return std::nullopt;
        Arc arc = take(found);
        if (!same(arc.points.front(), place)) std::reverse(arc.points.begin(), arc.points.end());
        return arc;
    }

private:
    /// Ends that are the same have keys within `reach`. Along a slanted direction few others have
    /// the same key: ends lie on sides of cells, which follow the parameters.
    static double key(const LinePoint& end) { return end.uv.x + 0.618 * end.uv.y; }
    static constexpr double reach = 2 * same_end;

    bool continues(std::size_t i, const LinePoint& place) const {
        return same(arcs_[i].points.front(), place) || same(arcs_[i].points.back(), place);
    }

    Arc take(std::size_t i) {
        taken_[i] = true;
        return std::move(arcs_[i]);
    }

    std::vector<Arc> arcs_;
    std::vector<bool> taken_;
    std::vector<std::pair<double, std::size_t>> ends_; ///< key and arc, by rising key
    std::size_t first_ = 0;
};

void append(PatchLine& line, const Arc& arc) {
    line.points.insert(line.points.end(), arc.points.begin() + 1, arc.points.end());
    line.deviation = std::max(line.deviation, arc.deviation);
    line.proved = line.proved && arc.cell.proved;
}

std::vector<PatchLine> joined(std::vector<Arc> arcs) {
    OpenArcs open(std::move(arcs));
    std::vector<PatchLine> lines;
    while (auto first = open.next()) {
        PatchLine line{first->cell.level, false, first->cell.proved, first->points,
                       first->deviation};
        for (int end = 0; end < 2; ++end) {
            while (auto arc = open.next_at(line.points.back())) append(line, *arc);
            std::reverse(line.points.begin(), line.points.end());
        }
        line.closed = line.points.size() > 2 && same(line.points.front(), line.points.back());
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace

Vec2 ZeroFunction::root(const Vec2& a, double at_a, const Vec2& b, double at_b) const {
    check_stop();
    constexpr double rounding = 2e-15; // of the patch
    const Vec2 way = b - a;
    const auto at = [&](double share) { return a + way * share; };
    return at(bracketed_root([&](double share) { return (*this)(at(share)); }, {0, at_a}, {1, at_b},
                             rounding / way.length()));
}

std::optional<LinePoint> ZeroFunction::between(const LinePoint& a, const LinePoint& b,
                                               double share) const {
    const Vec2 chord = b.uv - a.uv, middle = a.uv + chord * share, across(-chord.y, chord.x);
    for (double reach = 1.0 / 64; reach <= 1; reach *= 2) {
        const Vec2 low = unit_square.nearest(middle - across * reach),
                   high = unit_square.nearest(middle + across * reach);
        const double at_low = (*this)(low), at_high = (*this)(high);
        if ((at_low < 0) != (at_high < 0)) return point(root(low, at_low, high, at_high));
    }
    return std::nullopt;
}

double LevelFunction::operator()(const Vec2& uv) const {
    const SurfaceDerivatives s = evaluate(patch_, uv, 1);
    return field_.ratio(triple(s.position()), triple(s.du().cross(s.dv())), level_).above;
}

std::vector<PatchLine> lines_through(std::span<const LineCell> cells, const ZeroFunction& f,
                                     double chord_error) {
    std::vector<Arc> arcs;
    for (const LineCell& cell : cells) {
        const std::vector<Vec2> ends = crossings(f, cell.uv);
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
            Arc arc{cell, {}, 0};
            ArcRefiner(f, arc, chord_error).run(ends[i], ends[i + 1]);
            arcs.push_back(std::move(arc));
        }
    }
    return joined(std::move(arcs));
}

std::vector<PatchLine> patch_lines(const BezierPatchView& patch, const LineField& field,
                                   std::span<const double> levels,
                                   const PatchLineOptions& options) {
    std::vector<std::vector<LineCell>> cells(levels.size());
    for (const LineCell& cell : line_cells(patch, field, levels, options.cells))
        cells[cell.level].push_back(cell);
    std::vector<PatchLine> lines;
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const LevelFunction f(patch, field, levels[level]);
        std::vector<PatchLine> some = lines_through(cells[level], f, options.chord_error);
        std::move(some.begin(), some.end(), std::back_inserter(lines));
    }
    return lines;
}

} // namespace keiko
