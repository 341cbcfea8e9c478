#include "keiko/inspect/lines/contour_curves.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/curve_chains.h"
#include "keiko/inspect/basics/line_cells.h"
#include "keiko/inspect/basics/patch_fields.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/basics/visible_pieces.h"

#include <algorithm>

namespace keiko {
namespace {

/// Distance between trim tests on a curve, as a share of the face's size.
constexpr double trim_step = 5e-3;
/// Distance in mm between the ends of pieces that are one curve, and length of the shortest.
constexpr double same_end = 0.01;

BernsteinField constant(double value) {
    return BernsteinField(0, 0, {value}, 0);
}

/// The normal times the line of sight, and powers of the weight: 0 on the contour.
BernsteinField sight_field(const PlacedPatch& patch, const BezierPatchView& view,
                           const LineEye& eye) {
    const FieldTriple normal = without_zero_sides(normal_field(view, patch.rounding));
    FieldTriple sight{constant(eye.direction.x), constant(eye.direction.y),
                      constant(eye.direction.z)};
    if (!eye.parallel) {
        const HomogeneousField s = homogeneous_field(view, patch.rounding);
        const Vec3 from_eye = patch.middle - eye.point;
        for (unsigned k = 0; k < 3; ++k) sight[k] = s.p[k] + s.w * constant(from_eye[k]);
    }
    return dot(sight, normal);
}

/// The contour curves of one placed face.
class ContourSearch {
public:
    ContourSearch(const SurfaceModel& model, const PlacedFace& placed)
        : model_(model), placed_(placed), face_(model.faces[placed.face]), trims_(model, face_) {}

    std::vector<ContourLine> run(const LineEye& eye, double chord_error) {
        std::vector<PlacedPatch> patches;
        Box3 bounds;
        for (std::uint32_t i = 0; i < face_.patch_count; ++i) {
            patches.emplace_back(model_, face_.first_patch + i,
                                 model_.instances[placed_.instance].transform);
            bounds.extend(patches.back().box);
        }
        for (const PlacedPatch& patch : patches)
            search(patch, eye, chord_error, trim_step * bounds.size());
        std::vector<std::array<Vec3, 2>> ends;
        for (const PatchLine& piece : pieces_)
            ends.push_back({piece.points.front().place, piece.points.back().place});
        std::vector<ContourLine> curves;
        for (const CurveChain& chain : chain_curves(ends, same_end))
            if (ContourLine curve = curve_of(chain); curve.length > same_end)
                curves.push_back(std::move(curve));
        std::stable_sort(
            curves.begin(), curves.end(),
            [](const ContourLine& a, const ContourLine& b) { return a.length > b.length; });
        return curves;
    }

private:
    void search(const PlacedPatch& patch, const LineEye& eye, double chord_error, double step) {
        const BezierPatchView own = model_.patch(patch.index);
        const BezierPatchView view{own.degree_u, own.degree_v, patch.points};
        const BernsteinField field = sight_field(patch, view, eye);
        if (!(field.magnitude() > field.rounding())) return; // all of it is viewed edge-on
        const auto material = [&](const LinePoint& p) {
            return trims_.untrimmed() || trims_.contains(model_.face_parameters(patch.index, p.uv));
        };
        const std::vector<LineCell> cells = field_cells(field).cells;
        for (PatchLine& piece :
             material_pieces(cells, FieldZeros(patch, view, field), chord_error, step, material))
            pieces_.push_back(std::move(piece));
    }

    ContourLine curve_of(const CurveChain& chain) const {
        ContourLine curve{.instance = placed_.instance, .face = placed_.face};
        curve.closed = chain.closed;
        for (const ChainLink& link : chain.links) {
            const PatchLine& piece = pieces_[link.piece];
            std::vector<Vec3> points;
            for (const LinePoint& point : piece.points) points.push_back(point.place);
            if (link.turned) std::reverse(points.begin(), points.end());
            curve.points.insert(curve.points.end(), points.begin(), points.end());
            curve.proved = curve.proved && piece.proved;
            curve.deviation = std::max(curve.deviation, piece.deviation);
        }
        for (std::size_t i = 1; i < curve.points.size(); ++i)
            curve.length += (curve.points[i] - curve.points[i - 1]).length();
        return curve;
    }

    const SurfaceModel& model_;
    PlacedFace placed_;
    const Face& face_;
    TrimRegion trims_;
    std::vector<PatchLine> pieces_;
};

} // namespace

std::vector<ContourLine> contour_curves(const SurfaceModel& model, const LineEye& eye,
                                        double chord_error, const Job& job) {
    const std::vector<PlacedFace> faces = placed_faces(model);
    std::vector<std::vector<ContourLine>> found(faces.size());
    parallel_for(faces.size(), job, "contours", [&](std::size_t i) {
        found[i] = ContourSearch(model, faces[i]).run(eye, chord_error);
    });
    std::vector<ContourLine> curves;
    for (std::vector<ContourLine>& of_face : found)
        std::move(of_face.begin(), of_face.end(), std::back_inserter(curves));
    return curves;
}

} // namespace keiko
