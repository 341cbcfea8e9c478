#pragma once

#include "keiko/geometry/bezier/patch_height.h"
#include "keiko/geometry/trim/curve_stretch.h"
#include "keiko/geometry/trim/trim_region.h"

#include <optional>

namespace keiko {

/// A patch of a trimmed face, with the height of its places. Keeps references to the model and the
/// trims.
class PatchMaterial {
public:
    /// `height`: of a place in part coordinates.
    PatchMaterial(const SurfaceModel& model, std::uint32_t patch, const TrimRegion& trims,
                  const Height& height);

    /// The height over all of the patch, regardless of the trims.
    const PatchHeight& whole() const { return whole_; }
    const TrimRegion& trims() const { return trims_; }
    TrimSide classify(const Box2& uv) const { return trims_.classify(face_box(uv)); }
    bool contains(const Vec2& uv) const;

    /// The part of a stretch of a trim curve that is on the patch.
    struct Overlap {
        Box2 uv;            ///< holds that part
        bool whole = false; ///< all of the stretch is on the patch
    };
    /// The part of a stretch that is on the patch; nullopt for a stretch beside the patch.
    std::optional<Overlap> overlap(const CurveStretch& stretch) const;
    /// Bounds of the height along a stretch that is on the patch.
    struct CurveBound {
        double upper = 0;
        bool monotone = false; ///< it rises or falls all along
    };
    CurveBound bound(const CurveStretch& stretch, const Overlap& overlap) const;
    /// The height at a place in face parameters; nullopt if that is beside the patch.
    std::optional<double> height_at(const Vec2& face_parameters) const;

private:
    Box2 face_box(const Box2& uv) const;
    Vec2 to_patch(const Vec2& face_parameters) const;

    const SurfaceModel& model_;
    std::uint32_t patch_;
    const TrimRegion& trims_;
    Height height_;
    PatchHeight whole_;
    Box2 domain_; ///< face parameters of the patch, and a little more
};

/// True if material lies beside the stretch, at its local parameter s.
bool beside_material(const TrimRegion& trims, const CurveStretch& stretch, double s);

} // namespace keiko
