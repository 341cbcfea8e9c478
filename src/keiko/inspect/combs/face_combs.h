#pragma once

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/basics/visible_pieces.h"
#include "keiko/inspect/combs/comb_sample.h"
#include "keiko/inspect/combs/section_plane.h"

#include <optional>

namespace keiko {

/// Section of a face with a plane.
struct FaceSection {
    std::vector<CombPiece> pieces; ///< one a patch and stretch of material
    bool within = false;           ///< a patch lies in the plane
    std::vector<Vec3> touched;     ///< places at which the plane touches, beside the pieces
};

/// Finds and samples curves on one trimmed face. Keeps references.
class FaceCombs {
public:
    /// `size`: of the body, mm.
    FaceCombs(const SurfaceModel& model, const PlacedFace& placed, const CombOptions& options,
              double size);

    /// The section of the material of all patches of the face with a plane.
    FaceSection section(const SectionPlane& plane) const;
    /// The parts of the iso-curve at a share of the face's parameters that lie on material, one
    /// piece a patch.
    std::vector<CombPiece> iso_curve(bool by_u, double share) const;

private:
    struct PatchUse;
    /// Predicates that are evaluated at the places of a curve.
    struct CurveRules {
        std::function<bool(const LinePoint&)> material, on_border;
        BendAt bend;
    };

    void add_section(const PatchUse& patch, const SectionPlane& plane, FaceSection& section) const;
    std::vector<CombPiece> pieces(const PatchUse& patch, const MeetingField& curve,
                                  const CurveRules& rules) const;
    std::vector<CombPiece> meeting_pieces(const PatchUse& patch, const PlaneMeeting& meeting,
                                          const MeetingField& curve,
                                          const SectionPlane& plane) const;
    bool is_material(std::uint32_t patch, const Vec2& uv) const;
    std::optional<double> iso_parameter(std::uint32_t patch, bool by_u, double share) const;
    double local_share(std::uint32_t patch, bool by_u, double at) const;

    const SurfaceModel& model_;
    PlacedFace placed_;
    const Face& face_;
    TrimRegion trims_;
    const CombOptions& options_;
    double size_ = 0, sign_ = 1;
    Box2 domain_; ///< of the face's parameters
};

} // namespace keiko
