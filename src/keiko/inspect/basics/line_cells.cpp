#include "keiko/inspect/basics/line_cells.h"

#include "keiko/base/job.h"
#include "keiko/inspect/basics/field_model.h"
#include "keiko/inspect/basics/patch_box.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

namespace keiko {
namespace {

using Levels = std::vector<std::uint32_t>;

struct Task {
    PatchBox box;
    Levels levels; ///< not excluded yet
};

/// True if a side is crossed at most once.
bool clear_side(const Jet<TaylorModel>& f, bool by_x, double at) {
    return !may_vanish(by_x ? at_x(f.f, at) : at_y(f.f, at)) ||
           !may_vanish(by_x ? at_x(f.v, at) : at_y(f.u, at));
}

/// True if the zeros are at most one arc, strictly monotonic along x if `by_x`, else along y.
bool one_arc(const Jet<TaylorModel>& f, bool by_x) {
    return !may_vanish(by_x ? f.u : f.v) && clear_side(f, by_x, -1) && clear_side(f, by_x, 1);
}

double largest(const TaylorModel& model) {
    return std::abs(model.c[0]) + model.deviation();
}

double middle_of(const Levels& some, std::span<const double> levels) {
    const auto [low, high] = std::minmax_element(
        some.begin(), some.end(),
        [&](std::uint32_t a, std::uint32_t b) { return levels[a] < levels[b]; });
    return (levels[*low] + levels[*high]) / 2;
}

/// The field whose value is the coordinate along the lamps, from the same corner.
LineField field_along(const LineField& field) {
    const CPlaneFrame& plane = field.plane();
    CPlane exchanged;
    exchanged.origin = plane.origin;
    exchanged.u = plane.v, exchanged.v = plane.u * plane.length;
    return {field.look(), field.eye(), exchanged, plane.origin};
}

class CellSearch {
public:
    CellSearch(const LineField& field, std::span<const double> levels,
               const LineCellOptions& options)
        : field_(field), along_(field_along(field)), levels_(levels), options_(options) {}

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
        if (options_.unwanted && options_.unwanted(task.box.uv())) return;
        const double shift = middle_of(task.levels, levels_);
        const FieldModel model(task.box, field_, shift);
        if (!model.may_face_plane()) return;
        Levels left;
        for (const std::uint32_t level : task.levels)
            if (model.may_hold(levels_[level] - shift)) left.push_back(level);
        if (left.empty() || !may_meet_lamps(model)) return;
        const LineRatio<Jet<TaylorModel>> sloped = model.sloped();
        Levels undecided;
        double slope_u = 0, slope_v = 0; // the largest of the undecided levels
        for (const std::uint32_t level : left) {
            const Jet<TaylorModel> f = sloped.residual(levels_[level] - shift);
            const bool over_v = one_arc(f, true);
            if (over_v || one_arc(f, false)) {
                cells_.push_back({task.box.uv(), level, true, over_v});
                continue;
            }
            undecided.push_back(level);
            slope_u = std::max(slope_u, largest(f.u)), slope_v = std::max(slope_v, largest(f.v));
        }
        if (!undecided.empty()) cut(task, model, undecided, give_up, slope_u >= slope_v);
    }

    /// False only if all rays of the box that run to the C-plane pass the ends of the lamps.
    /// Isophotes have none.
    bool may_meet_lamps(const FieldModel& model) const {
        constexpr double rounding = 1e-9; // of a coordinate along the lamps, in their lengths
        if (field_.look() == LineLook::isophote) return true;
        const double length = field_.plane().length, margin = rounding * length;
        return model.may_meet(along_, -margin, length + margin);
    }

    void cut(const Task& task, const FieldModel& model, const Levels& levels, bool give_up,
             bool steeper_u) {
        const double least =
            model.may_be_singular() ? options_.least_singular_extent : options_.least_extent;
        const Vec2 extent = task.box.uv().extent();
        const bool can_u = extent.x > least, can_v = extent.y > least;
        if (give_up || (!can_u && !can_v)) {
            for (const std::uint32_t level : levels)
                cells_.push_back({task.box.uv(), level, false, false});
            return;
        }
        for (PatchBox& half : task.box.halves(can_u && (!can_v || steeper_u)))
            open_.push_back({std::move(half), levels});
    }

    const LineField& field_;
    const LineField along_;
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

/// A field with its slopes by u and v.
struct SlopedField {
    explicit SlopedField(const BernsteinField& field)
        : f(field), u(field.derivative(true)), v(field.derivative(false)) {}

    const BernsteinField& f;
    BernsteinField u, v;
};

/// True if a side is crossed at most once.
bool clear_side(const SlopedField& field, bool by_u, bool upper) {
    return !field.f.side_range(by_u, upper).holds_zero() ||
           !(by_u ? field.v : field.u).side_range(by_u, upper).holds_zero();
}

/// True if the zeros are at most one arc, strictly monotonic along u if `by_u`, else along v.
bool one_arc(const SlopedField& field, bool by_u) {
    return !(by_u ? field.u : field.v).range().holds_zero() && clear_side(field, by_u, false) &&
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
        const SlopedField sloped(f);
        const bool over_v = one_arc(sloped, true);
        if (over_v || one_arc(sloped, false)) {
            found.cells.push_back({piece.uv, 0, true, over_v});
            continue;
        }
        const Vec2 extent = piece.uv.extent();
        const bool can_u = extent.x > options.least_extent, can_v = extent.y > options.least_extent;
        if (looked >= options.most_boxes || (!can_u && !can_v)) {
            found.cells.push_back({piece.uv, 0, false, false});
            continue;
        }
        const bool steeper_u = sloped.u.magnitude() >= sloped.v.magnitude();
        cut(piece, can_u && (!can_v || steeper_u), open);
    }
    return found;
}

} // namespace keiko
