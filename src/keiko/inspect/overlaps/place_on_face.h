#pragma once

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/overlaps/face_inside.h"

#include <optional>
#include <vector>

namespace keiko {

/// The nearest place of a face's material to a given one.
struct PlaceOnFace {
    double distance = 0; ///< mm
    bool deep = false;   ///< farther than the reach from all borders of the face
};

/// Finds places of the material of a placed face that are near others. Keeps references to the
/// model.
class NearFace {
public:
    /// Places up to `reach` mm away count, and so do borders up to that beyond the material.
    NearFace(const SurfaceModel& model, const PlacedFace& face, double reach);

    /// A place of the material within reach of `p`, world, mm; nullopt if there is none.
    std::optional<PlaceOnFace> find(const Vec3& p);

private:
    std::optional<PlaceOnFace> search(const PlacedPatch& patch, const BezierPatchView& whole,
                                      const Box2& box, const Vec3& p, int depth);
    std::optional<PlaceOnFace> foot_in(const PlacedPatch& patch, const BezierPatchView& whole,
                                       const Box2& box, const BezierPatchView& piece,
                                       const Vec3& p);

    const SurfaceModel& model_;
    FaceInside inside_;
    std::vector<PlacedPatch> patches_;
    double reach_; ///< mm
};

} // namespace keiko
