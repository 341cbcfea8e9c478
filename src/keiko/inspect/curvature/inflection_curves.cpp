#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/curve_chains.h"
#include "keiko/inspect/basics/line_cells.h"
#include "keiko/inspect/basics/visible_pieces.h"
#include "keiko/inspect/curvature/face_measure.h"
#include "keiko/inspect/curvature/parabolic_field.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Distance between trim tests on a curve, as a share of the face's size.
constexpr double trim_step = 5e-3;
/// Distance in mm between the ends of pieces that are one curve.
constexpr double same_end = 0.01;
constexpr std::size_t most_boxes = 4000; ///< of a patch

struct Piece {
    std::vector<Vec3> points;
    double rate = 0, deviation = 0;
    bool proved = true;
    int side = 0; ///< sign of the Gaussian curvature beside a side of the patch; 0: inside
};

double distance(const Vec3& a, const Vec3& b) {
    return (a - b).length();
}

double length_of(const std::vector<Vec3>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
    return length;
}

class InflectionSearch {
public:
    InflectionSearch(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                     const InflectionOptions& options)
        : model_(model), face_(model.faces[face]), trims_(model, face_), options_(options) {
        Box3 bounds;
        for (std::uint32_t i = 0; i < face_.patch_count; ++i) {
            patches_.emplace_back(model, face_.first_patch + i,
                                  model.instances[instance].transform);
            bounds.extend(patches_.back().box);
        }
        size_ = bounds.size();
    }

    std::vector<InflectionCurve> run() {
        for (const PlacedPatch& patch : patches_) search(patch);
        pair_sides();
        std::vector<std::array<Vec3, 2>> ends;
        for (const Piece& piece : pieces_)
            ends.push_back({piece.points.front(), piece.points.back()});
        std::vector<InflectionCurve> curves;
        for (const CurveChain& chain : chain_curves(ends, same_end)) {
            InflectionCurve curve = curve_of(chain);
            if (curve.length > same_end && curve.rate * size_ > options_.flat_change)
                curves.push_back(std::move(curve));
        }
        std::stable_sort(
            curves.begin(), curves.end(),
            [](const InflectionCurve& a, const InflectionCurve& b) { return a.length > b.length; });
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
        const BezierPatchView own = model_.patch(patch.index);
        const BezierPatchView view{own.degree_u, own.degree_v, patch.points};
        if (!bends_both_ways(view)) return;
        const auto field = parabolic_field(view, patch.rounding);
        if (!field) return;
        LineCellOptions cells;
        cells.most_boxes = most_boxes;
        add(patch, view, field_cells(field->inner, cells).cells, field->inner, 0);
        for (const ParabolicSide& side : field->sides) {
            const LineCell whole{unit_square, 0, true, side.by_u};
            if (side.sign != 0)
                add(patch, view, {whole}, iso_field(side.by_u, side.upper ? 1 : 0), side.sign);
        }
    }

    void add(const PlacedPatch& patch, const BezierPatchView& view,
             const std::vector<LineCell>& cells, const BernsteinField& field, int side) {
        const FieldZeros zeros(patch, view, field);
        const auto material = [&](const LinePoint& p) {
            return trims_.untrimmed() || trims_.contains(model_.face_parameters(patch.index, p.uv));
        };
        for (const PatchLine& part :
             material_pieces(cells, zeros, options_.chord_error, trim_step * size_, material)) {
            Piece piece{{}, 0, part.deviation, part.proved, side};
            for (const LinePoint& p : part.points) {
                piece.points.push_back(p.place);
                piece.rate = std::max(piece.rate, parabolic_rate(evaluate(view, p.uv, 3)));
            }
            pieces_.push_back(std::move(piece));
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
        const auto near = [](const Vec3& p, const Vec3& q) { return distance(p, q) < same_end; };
        const Vec3 &a0 = a.points.front(), &a1 = a.points.back(), &b0 = b.points.front(),
                   &b1 = b.points.back();
        return (near(a0, b0) && near(a1, b1)) || (near(a0, b1) && near(a1, b0));
    }

    InflectionCurve curve_of(const CurveChain& chain) const {
        InflectionCurve curve;
        curve.closed = chain.closed;
        for (const ChainLink& link : chain.links) {
            const Piece& piece = pieces_[link.piece];
            std::vector<Vec3> points = piece.points;
            if (link.turned) std::reverse(points.begin(), points.end());
            curve.points.insert(curve.points.end(), points.begin(), points.end());
            curve.proved = curve.proved && piece.proved;
            curve.rate = std::max(curve.rate, piece.rate);
            curve.deviation = std::max(curve.deviation, piece.deviation);
        }
        curve.length = length_of(curve.points);
        return curve;
    }

    const SurfaceModel& model_;
    const Face& face_;
    TrimRegion trims_;
    const InflectionOptions& options_;
    double size_ = 0; ///< mm
    std::vector<PlacedPatch> patches_;
    std::vector<Piece> pieces_;
};

} // namespace

std::vector<InflectionCurve> inflection_curves(const SurfaceModel& model, std::uint32_t instance,
                                               std::uint32_t face,
                                               const InflectionOptions& options) {
    return InflectionSearch(model, instance, face, options).run();
}

} // namespace keiko
