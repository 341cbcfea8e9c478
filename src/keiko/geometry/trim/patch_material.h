#pragma once

#include "keiko/geometry/bezier/patch_height.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/trim/trim_region.h"

#include <array>
#include <optional>
#include <vector>

namespace keiko {

/// A stretch of a trim curve, as a Bezier curve over s in [0, 1]. Weights must be positive.
class CurveStretch {
public:
    /// The whole of a curve.
    explicit CurveStretch(const BezierCurveView& curve)
        : CurveStretch({curve.points.begin(), curve.points.end()}, 1) {}
    /// A straight stretch.
    CurveStretch(const Vec2& first, const Vec2& last)
        : CurveStretch({Vec3(first.x, first.y, 1), Vec3(last.x, last.y, 1)}, 1) {}

    /// Its begin, in face parameters.
    const Vec2& first() const { return first_; }
    /// Its end, in face parameters.
    const Vec2& last() const { return last_; }
    /// A box of face parameters that holds the stretch.
    Box2 box() const { return hull_bounds(BezierCurveView{points_}); }
    /// Share of its curve, 0 to 1.
    double share() const { return share_; }
    /// The parts before and after s = 1/2, each with half the share.
    std::array<CurveStretch, 2> halves() const;
    /// Place and its first derivative by s, in face parameters.
    std::array<Vec2, 4> at(double s) const { return evaluate(BezierCurveView{points_}, s, 1); }

    /// Ranges over the stretch of the height's derivatives by s.
    struct Rates {
        Interval first;  ///< mm in a unit of s
        Interval second; ///< mm in a unit of s squared
    };
    /// Ranges of the height's rates. `around`: the height on a box of the patch that holds the
    /// stretch.
    Rates rates(const Patch& patch, const PatchHeight& around) const;

private:
    CurveStretch(std::vector<Vec3> points, double share);

    std::vector<Vec3> points_; ///< homogeneous
    Vec2 first_, last_;
    double share_;
};

/// The curves of a face's loops, and the straight ones that close them where they do not quite
/// meet, as in TrimRegion.
std::vector<CurveStretch> border_of(const SurfaceModel& model, const Face& face);

/// A patch of a trimmed face, with the height of its places. Keeps references to the model and the
/// trims.
class PatchMaterial {
public:
    /// `height`: of a place in part coordinates.
    PatchMaterial(const SurfaceModel& model, std::uint32_t patch, const TrimRegion& trims,
                  const Height& height);

    /// The height over all of the patch, regardless of the trims.
    const PatchHeight& whole() const { return whole_; }
    /// Trims of the face.
    const TrimRegion& trims() const { return trims_; }
    /// Position of a box of the patch's parameters relative to the trims.
    TrimSide classify(const Box2& uv) const { return trims_.classify(face_box(uv)); }
    /// True if the place at the patch parameters `uv` is material.
    bool contains(const Vec2& uv) const;

    /// The part of a stretch of a trim curve that is on the patch.
    struct Overlap {
        Box2 uv;            ///< holds that part
        bool whole = false; ///< all of the stretch is on the patch
    };
    /// The part of a stretch that is on the patch; nullopt for a stretch beside the patch.
    std::optional<Overlap> overlap(const CurveStretch& stretch) const;
    /// Bound of the height along a stretch, as far as it is on the patch.
    struct CurveBound {
        double upper = 0;      ///< mm: no place of it is higher
        bool monotone = false; ///< it rises or falls all along
    };
    /// The bound of a stretch by its overlap with the patch. Only a stretch that is on the patch as
    /// a whole may be monotone.
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
