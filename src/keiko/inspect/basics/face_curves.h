#pragma once

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/line_cells.h"
#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/inspect/basics/placed_face.h"

#include <span>
#include <vector>

namespace keiko {

/// Distance in mm between the ends of pieces that are one curve, and length of the shortest curve.
constexpr double same_curve_end = 0.01;

/// A curve on a face, of pieces on its patches.
struct FaceCurve {
    bool closed = false;               ///< the last point is the first one again
    bool proved = true;                ///< the course of every piece
    double length = 0;                 ///< mm
    double deviation = 0;              ///< mm, about the largest distance between curve and chords
    std::vector<Vec3> points{};        ///< world, mm
    std::vector<std::size_t> pieces{}; ///< indices of those that it was joined from
};

/// Search for the curves of a placed face on which polynomial fields of its patches are 0. Keeps a
/// reference to the model.
class FaceCurveSearch {
public:
    FaceCurveSearch(const SurfaceModel& model, const PlacedFace& placed);

    /// The patches of the face, each about its own middle.
    const std::vector<PlacedPatch>& patches() const { return patches_; }
    /// Surface of such a patch, about its middle.
    BezierPatchView view_of(const PlacedPatch& patch) const;
    /// Diagonal of the box around the control points, mm.
    double size() const { return size_; }

    /// The zeros of a field in cells of a patch, where the face has material. The points are in
    /// world coordinates. `chord_error` in mm.
    std::vector<PatchLine> pieces(const PlacedPatch& patch, const BernsteinField& field,
                                  std::span<const LineCell> cells, double chord_error) const;

private:
    const SurfaceModel& model_;
    TrimRegion trims_;
    std::vector<PlacedPatch> patches_;
    double size_ = 0;
};

/// Pieces joined to curves where their ends are within same_curve_end, the longest curve first;
/// those that are no longer than that are left out.
std::vector<FaceCurve> joined_pieces(std::span<const PatchLine> pieces);

} // namespace keiko
