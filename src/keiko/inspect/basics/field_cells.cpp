#include "keiko/inspect/basics/field_cells.h"

#include "keiko/base/job.h"

#include <deque>

namespace keiko {
namespace {

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
