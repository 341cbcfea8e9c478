#include "keiko/inspect/lines/contour_curves.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/face_curves.h"
#include "keiko/inspect/basics/patch_fields.h"

#include <algorithm>

namespace keiko {
namespace {

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
std::vector<ContourLine> face_contours(const SurfaceModel& model, const PlacedFace& placed,
                                       const LineEye& eye, double chord_error) {
    const FaceCurveSearch search(model, placed);
    std::vector<PatchLine> pieces;
    for (const PlacedPatch& patch : search.patches()) {
        const BernsteinField field = sight_field(patch, search.view_of(patch), eye);
        if (!(field.magnitude() > field.rounding())) continue; // all of it is viewed edge-on
        for (PatchLine& piece : search.pieces(patch, field, field_cells(field).cells, chord_error))
            pieces.push_back(std::move(piece));
    }
    std::vector<ContourLine> contours;
    for (FaceCurve& curve : joined_pieces(pieces))
        contours.push_back({placed.instance, placed.face, curve.closed, curve.proved, curve.length,
                            curve.deviation, std::move(curve.points)});
    return contours;
}

} // namespace

std::vector<ContourLine> contour_curves(const SurfaceModel& model, const LineEye& eye,
                                        double chord_error, const Job& job) {
    const std::vector<PlacedFace> faces = placed_faces(model);
    std::vector<std::vector<ContourLine>> found(faces.size());
    parallel_for(faces.size(), job, "contours", [&](std::size_t i) {
        found[i] = face_contours(model, faces[i], eye, chord_error);
    });
    std::vector<ContourLine> curves;
    for (std::vector<ContourLine>& of_face : found)
        std::move(of_face.begin(), of_face.end(), std::back_inserter(curves));
    return curves;
}

} // namespace keiko
