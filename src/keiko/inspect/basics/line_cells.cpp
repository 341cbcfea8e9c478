#include "keiko/inspect/basics/line_cells.h"

#include "keiko/base/job.h"
#include "keiko/inspect/basics/patch_box.h"

#include <algorithm>
#include <deque>
#include <numeric>

namespace keiko {
namespace {

using Levels = std::vector<std::uint32_t>;

struct Task {
    PatchBox box;
    Levels levels; ///< not excluded yet
};

/// The field over one box. Levels count from their middle, which keeps the bounds tight.
class BoxField {
public:
    BoxField(const PatchBox& box, const LineField& field, double shift)
        : box_(box), field_(field), shift_(shift), center_(thin(0.5, 0.5)) {
        const PatchBox::Ranges r = box.ranges();
        over_box_ = field.ratio(r.place, cross(r.dx, r.dy), shift);
    }

    /// Natural bound or mean value form, whichever is tighter at either end.
    Jet<Interval> bounds(double level) const {
        Jet<Interval> all = over_box_.residual(level - shift_);
        const Interval reach(-0.5, 0.5);
        all.f =
            all.f.intersection(center_.residual(level - shift_) + all.u * reach + all.v * reach);
        return all;
    }
    /// True if the level cannot occur on the side x or y = `at`, along which the slope is known.
    bool clear_side(double level, bool x_fixed, double at, const Interval& slope) const {
        const auto middle = x_fixed ? thin(at, 0.5) : thin(0.5, at);
        const Interval along = middle.residual(level - shift_) + slope * Interval(-0.5, 0.5);
        return !along.holds_zero();
    }

private:
    LineRatio<Interval> thin(double x, double y) const {
        const PatchBox::Values s = box_.values(x, y);
        return field_.ratio(s.place, cross(s.dx, s.dy), shift_);
    }

    const PatchBox& box_;
    const LineField& field_;
    double shift_;
    LineRatio<Interval> center_;
    LineRatio<Jet<Interval>> over_box_;
};

/// True if the level's line is at most one arc, strictly monotonic along x if `by_x`, else along y.
bool one_arc(const BoxField& box, double level, const Jet<Interval>& bounds, bool by_x) {
    const Interval& strict = by_x ? bounds.u : bounds.v;
    const Interval& other = by_x ? bounds.v : bounds.u;
    if (strict.holds_zero()) return false;
    if (!other.holds_zero()) return true;
    return box.clear_side(level, by_x, 0, other) && box.clear_side(level, by_x, 1, other);
}

double middle_of(const Levels& some, std::span<const double> levels) {
    const auto [low, high] = std::minmax_element(
        some.begin(), some.end(),
        [&](std::uint32_t a, std::uint32_t b) { return levels[a] < levels[b]; });
    return (levels[*low] + levels[*high]) / 2;
}

class CellSearch {
public:
    CellSearch(const LineField& field, std::span<const double> levels,
               const LineCellOptions& options)
        : field_(field), levels_(levels), options_(options) {}

    std::vector<LineCell> run(const BezierPatchView& patch) {
        Levels every(levels_.size());
        std::iota(every.begin(), every.end(), 0u);
        if (!every.empty()) open_.push_back({PatchBox(patch), std::move(every)});
        for (std::size_t looked = 0; !open_.empty(); ++looked) {
            check_stop();
            const Task task = std::move(open_.front());
            open_.pop_front();
            look_at(task, looked >= options_.most_boxes);
        }
        return std::move(cells_);
    }

private:
    void look_at(const Task& task, bool give_up) {
        const BoxField box(task.box, field_, middle_of(task.levels, levels_));
        Levels undecided;
        double slope_u = 0, slope_v = 0; // the largest of the undecided levels
        for (const std::uint32_t level : task.levels) {
            const Jet<Interval> bounds = box.bounds(levels_[level]);
            if (!bounds.f.holds_zero()) continue;
            const bool over_v = one_arc(box, levels_[level], bounds, true);
            if (over_v || one_arc(box, levels_[level], bounds, false)) {
                cells_.push_back({task.box.uv(), level, true, over_v});
                continue;
            }
            undecided.push_back(level);
            slope_u = std::max(slope_u, bounds.u.magnitude());
            slope_v = std::max(slope_v, bounds.v.magnitude());
        }
        if (undecided.empty()) return;
        const Vec2 extent = task.box.uv().extent();
        const bool can_u = extent.x > options_.least_extent;
        const bool can_v = extent.y > options_.least_extent;
        if (give_up || (!can_u && !can_v)) {
            for (const std::uint32_t level : undecided)
                cells_.push_back({task.box.uv(), level, false, false});
            return;
        }
        const bool by_u = can_u && (!can_v || slope_u >= slope_v);
        for (PatchBox& half : task.box.halves(by_u)) open_.push_back({std::move(half), undecided});
    }

    const LineField& field_;
    std::span<const double> levels_;
    const LineCellOptions& options_;
    std::deque<Task> open_;
    std::vector<LineCell> cells_;
};

/// Share of a box at which it is cut. It is not the middle, where symmetric parts tend to have
/// their curves.
constexpr double cut_share = 0.4811;

struct Piece {
    BernsteinField field;
    Box2 uv;
};

/// True if a side is crossed at most once.
bool clear_side(const BernsteinField& field, bool by_u, bool upper) {
    return !field.side_range(by_u, upper).holds_zero() ||
           !field.derivative(!by_u).side_range(by_u, upper).holds_zero();
}

/// True if the zeros are at most one arc, strictly monotonic along u if `by_u`, else along v.
bool one_arc(const BernsteinField& field, bool by_u) {
    return !field.derivative(by_u).range().holds_zero() && clear_side(field, by_u, false) &&
           clear_side(field, by_u, true);
}

void cut(const Piece& piece, bool by_u, std::deque<Piece>& open) {
    const double at = by_u ? piece.uv.lower.x + cut_share * piece.uv.extent().x
                           : piece.uv.lower.y + cut_share * piece.uv.extent().y;
    auto [first, second] = piece.field.parts(by_u, cut_share);
    Box2 low = piece.uv, high = piece.uv;
    (by_u ? low.upper.x : low.upper.y) = at;
    (by_u ? high.lower.x : high.lower.y) = at;
    open.push_back({std::move(first), low});
    open.push_back({std::move(second), high});
}

} // namespace

std::vector<LineCell> line_cells(const BezierPatchView& patch, const LineField& field,
                                 std::span<const double> levels, const LineCellOptions& options) {
    return CellSearch(field, levels, options).run(patch);
}

FieldCells field_cells(const BernsteinField& field, const LineCellOptions& options) {
    FieldCells found;
    std::deque<Piece> open{{field, unit_square}};
    for (std::size_t looked = 0; !open.empty(); ++looked) {
        check_stop();
        const Piece piece = std::move(open.front());
        open.pop_front();
        const BernsteinField& f = piece.field;
        if (!f.range().holds_zero()) continue;
        if (!(f.magnitude() > f.rounding())) {
            found.blank.push_back(piece.uv);
            continue;
        }
        const bool over_v = one_arc(f, true);
        if (over_v || one_arc(f, false)) {
            found.cells.push_back({piece.uv, 0, true, over_v});
            continue;
        }
        const Vec2 extent = piece.uv.extent();
        const bool can_u = extent.x > options.least_extent, can_v = extent.y > options.least_extent;
        if (looked >= options.most_boxes || (!can_u && !can_v)) {
            found.cells.push_back({piece.uv, 0, false, false});
            continue;
        }
        const bool steeper_u = f.derivative(true).magnitude() >= f.derivative(false).magnitude();
        cut(piece, can_u && (!can_v || steeper_u), open);
    }
    return found;
}

} // namespace keiko
