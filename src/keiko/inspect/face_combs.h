#pragma once

#include "keiko/inspect/comb_curves.h"
#include "keiko/inspect/field_zeros.h"
#include "keiko/patch/trim_region.h"

#include <optional>

namespace keiko {

/// A face as it is placed.
struct CombFace {
    std::uint32_t instance = 0, face = 0;
};

/// Which curves of a face.
struct CombFamily {
    CombCurve::Kind kind = CombCurve::Kind::section;
    SectionPlane plane{}; ///< of sections
    double share = 0;     ///< of iso-curves: of the face's parameters
};

/// Finds and samples curves on one trimmed face. Keeps references.
class FaceCombs {
public:
    /// `size`: of the body, mm.
    FaceCombs(const SurfaceModel& model, const CombFace& placed, const CombOptions& options,
              double size);

    /// What of the family's curves is material, a piece a patch.
    std::vector<CombPiece> run(const CombFamily& family) const;

private:
    struct Point {
        LinePoint at;
        CombSample sample;
    };

    void run_on(std::uint32_t patch, const CombFamily& family,
                std::vector<CombPiece>& pieces) const;
    std::optional<BernsteinField> field_of(const CombFamily& family, const PlacedPatch& patch,
                                           const BezierPatchView& view) const;
    double local_share(std::uint32_t patch, bool by_u, double at) const;
    std::optional<CombSample> sample_at(const CombFamily& family, const BezierPatchView& view,
                                        const LinePoint& at) const;
    std::vector<CombSample> samples(const CombFamily& family, const BezierPatchView& view,
                                    const ZeroFunction& zeros, const PatchLine& line) const;

    const SurfaceModel& model_;
    CombFace placed_;
    const Face& face_;
    TrimRegion trims_;
    const CombOptions& options_;
    double size_ = 0, sign_ = 1;
    Box2 domain_; ///< of the face's parameters
};

} // namespace keiko
