#pragma once

#include "keiko/geometry/bezier/patch_height.h"
#include "keiko/geometry/model/surface_model.h"

#include <array>
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

    const Vec2& first() const { return first_; }
    const Vec2& last() const { return last_; }
    /// A box of face parameters that holds the stretch.
    Box2 box() const { return hull_bounds(BezierCurveView{points_}); }
    /// Share of its curve, 0 to 1.
    double share() const { return share_; }
    std::array<CurveStretch, 2> halves() const;
    /// Place and its first derivative by s, in face parameters.
    std::array<Vec2, 4> at(double s) const { return evaluate(BezierCurveView{points_}, s, 1); }

    /// Ranges over the stretch of the height's first two derivatives by s. `around`: the height on
    /// a box of the patch that holds the stretch.
    struct Rates {
        Interval first, second;
    };
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

} // namespace keiko
