#include "keiko/inspect/basics/face_curves.h"

#include "keiko/inspect/basics/curve_chains.h"
#include "keiko/inspect/basics/visible_pieces.h"

#include <algorithm>

namespace keiko {
namespace {

/// Distance between trim tests on a curve, as a share of the face's size.
constexpr double trim_step = 5e-3;

FaceCurve curve_of(const CurveChain& chain, std::span<const PatchLine> pieces) {
    FaceCurve curve{.closed = chain.closed};
    for (const ChainLink& link : chain.links) {
        const PatchLine& piece = pieces[link.piece];
        const auto begin = static_cast<std::ptrdiff_t>(curve.points.size());
        for (const LinePoint& point : piece.points) curve.points.push_back(point.place);
        if (link.turned) std::reverse(curve.points.begin() + begin, curve.points.end());
        curve.proved = curve.proved && piece.proved;
        curve.deviation = std::max(curve.deviation, piece.deviation);
        curve.pieces.push_back(link.piece);
    }
    for (std::size_t i = 1; i < curve.points.size(); ++i)
        curve.length += (curve.points[i] - curve.points[i - 1]).length();
    return curve;
}

} // namespace

FaceCurveSearch::FaceCurveSearch(const SurfaceModel& model, const PlacedFace& placed)
    : model_(model), trims_(model, model.faces[placed.face]) {
    const Face& face = model.faces[placed.face];
    Box3 bounds;
    for (std::uint32_t i = 0; i < face.patch_count; ++i) {
        patches_.emplace_back(model, face.first_patch + i,
                              model.instances[placed.instance].transform);
        bounds.extend(patches_.back().box);
    }
    size_ = bounds.size();
}

BezierPatchView FaceCurveSearch::view_of(const PlacedPatch& patch) const {
    const BezierPatchView own = model_.patch(patch.index);
    return {own.degree_u, own.degree_v, patch.points};
}

std::vector<PatchLine> FaceCurveSearch::pieces(const PlacedPatch& patch,
                                               const BernsteinField& field,
                                               std::span<const LineCell> cells,
                                               double chord_error) const {
    const BezierPatchView view = view_of(patch);
    const auto material = [&](const LinePoint& p) {
        return trims_.untrimmed() || trims_.contains(model_.face_parameters(patch.index, p.uv));
    };
    return material_pieces(cells, FieldZeros(patch, view, field), chord_error, trim_step * size_,
                           material);
}

std::vector<FaceCurve> joined_pieces(std::span<const PatchLine> pieces) {
    std::vector<std::array<Vec3, 2>> ends;
    for (const PatchLine& piece : pieces)
        ends.push_back({piece.points.front().place, piece.points.back().place});
    std::vector<FaceCurve> curves;
    for (const CurveChain& chain : chain_curves(ends, same_curve_end))
        if (FaceCurve curve = curve_of(chain, pieces); curve.length > same_curve_end)
            curves.push_back(std::move(curve));
    std::stable_sort(curves.begin(), curves.end(),
                     [](const FaceCurve& a, const FaceCurve& b) { return a.length > b.length; });
    return curves;
}

} // namespace keiko
