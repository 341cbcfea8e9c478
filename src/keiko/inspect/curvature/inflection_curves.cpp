#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/inspect/basics/face_curves.h"
#include "keiko/inspect/basics/visible_pieces.h"
#include "keiko/inspect/curvature/face_measure.h"
#include "keiko/inspect/curvature/parabolic_field.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr std::size_t most_boxes = 4000; ///< of a patch

struct Piece {
    PatchLine line;
    double rate = 0; ///< 1/mm2: the fastest change of the curvature across it
    int side = 0;    ///< sign of the Gaussian curvature beside a side of the patch; 0: inside
};

class InflectionSearch {
public:
    InflectionSearch(const SurfaceModel& model, const PlacedFace& placed,
                     const InflectionOptions& options)
        : face_(model, placed), options_(options) {}

    std::vector<InflectionCurve> run() {
        for (const PlacedPatch& patch : face_.patches()) search(patch);
        pair_sides();
        std::vector<PatchLine> lines;
        for (Piece& piece : pieces_) lines.push_back(std::move(piece.line));
        std::vector<InflectionCurve> curves;
        for (FaceCurve& found : joined_pieces(lines)) {
            double rate = 0;
            for (const std::size_t i : found.pieces) rate = std::max(rate, pieces_[i].rate);
            if (rate * face_.size() > options_.flat_change)
                curves.push_back({found.closed, found.proved, found.length, rate, found.deviation,
                                  std::move(found.points)});
        }
        return curves;
    }

private:
    /// True if a patch is curved in its flatter direction at any of a few places.
    bool bends_both_ways(const BezierPatchView& view) const {
        constexpr int count = 6;
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) {
                const Vec2 uv((i + 0.5) / count, (j + 0.5) / count);
                const SurfaceDerivatives s = evaluate(view, uv, 2);
                const std::optional<Vec3> normal = unit_normal(s, uv);
                if (!normal) continue;
                const auto k = reliable_curvatures(s, *normal);
                if (k && std::min(std::abs(k->k1), std::abs(k->k2)) > options_.flat_change)
                    return true;
            }
        return false;
    }

    void search(const PlacedPatch& patch) {
        const BezierPatchView view = face_.view_of(patch);
        if (!bends_both_ways(view)) return;
        const auto field = parabolic_field(view, patch.rounding);
        if (!field) return;
        LineCellOptions cells;
        cells.most_boxes = most_boxes;
        add(patch, field_cells(field->inner, cells).cells, field->inner, 0);
        for (const ParabolicSide& side : field->sides) {
            const LineCell whole{unit_square, 0, true, side.by_u};
            if (side.sign != 0)
                add(patch, {whole}, iso_field(side.by_u, side.upper ? 1 : 0), side.sign);
        }
    }

    void add(const PlacedPatch& patch, const std::vector<LineCell>& cells,
             const BernsteinField& field, int side) {
        const BezierPatchView view = face_.view_of(patch);
        for (PatchLine& line : face_.pieces(patch, field, cells, options_.chord_error)) {
            double rate = 0;
            for (const LinePoint& p : line.points)
                rate = std::max(rate, parabolic_rate(evaluate(view, p.uv, 3)));
            pieces_.push_back({std::move(line), rate, side});
        }
    }

    /// Pairs the pieces along sides. The curvature changes its sign there only if the patch beyond
    /// has the other sign; one of the two pieces then stays.
    void pair_sides() {
        std::vector<Piece> kept;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const Piece& piece = pieces_[i];
            const auto other_half = [&](const Piece& other) {
                return other.side == -piece.side && same_ends(other, piece);
            };
            if (piece.side == 0 || std::any_of(pieces_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                               pieces_.end(), other_half))
                kept.push_back(piece);
        }
        pieces_ = std::move(kept);
    }

    static bool same_ends(const Piece& a, const Piece& b) {
        const auto near = [](const LinePoint& p, const LinePoint& q) {
            return (p.place - q.place).length() < same_curve_end;
        };
        const LinePoint &a0 = a.line.points.front(), &a1 = a.line.points.back(),
                        &b0 = b.line.points.front(), &b1 = b.line.points.back();
        return (near(a0, b0) && near(a1, b1)) || (near(a0, b1) && near(a1, b0));
    }

    FaceCurveSearch face_;
    const InflectionOptions& options_;
    std::vector<Piece> pieces_;
};

} // namespace

std::vector<InflectionCurve> inflection_curves(const SurfaceModel& model, std::uint32_t instance,
                                               std::uint32_t face,
                                               const InflectionOptions& options) {
    return InflectionSearch(model, {instance, face}, options).run();
}

} // namespace keiko
