#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/patch_grid.h"

#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// The border of a placed face at one point; all vectors in world coordinates.
struct BoundaryFrame {
    Vec3 position{0};           ///< mm
    Vec3 tangent{0};            ///< unit, in the direction of the curve
    Vec3 normal{0};             ///< unit, along du x dv
    Vec3 inward{0};             ///< unit, tangent to the surface, from the border into the material
    SurfaceDerivatives surface; ///< by patch parameters, to the requested order
};

/// A trim curve as a curve in space: the exact surface along the exact p-curve, placed by its
/// instance. Keeps references to its model and grid.
class SurfaceCurve {
public:
    /// `p_curve` in face parameters; `material_left`: the material lies to the left of its run
    /// in the parameter plane.
    SurfaceCurve(const SurfaceModel& model, const PatchGrid& grid, const Affine& transform,
                 BezierCurveView p_curve, bool material_left)
        : model_(&model),
          grid_(&grid),
          transform_(&transform),
          p_curve_(p_curve),
          side_(material_left ? 1 : -1) {}

    /// Position in mm and its first two derivatives by t, t in [0, 1].
    struct Point {
        Vec3 position{0}, first{0}, second{0}; ///< mm, and its derivatives by t
    };
    /// Position and derivatives at t in [0, 1].
    Point at(double t) const;
    /// Frame of the border; nullopt if the curve is stationary or the surface is singular, as at a
    /// pole. `order` is that of the surface's derivatives, 2 or 3.
    std::optional<BoundaryFrame> frame(double t, int order = 2) const;
    /// Arc length in mm between two parameters, in either order. It is integrated from patch change
    /// to patch change, since the speed may have a jump or a kink there.
    double length(double begin, double end) const;
    /// Arc length from `begin` to a greater parameter `end` with known patch changes between them,
    /// in rising order.
    double length(double begin, double end, std::span<const double> changes) const;
    /// Face parameters at t.
    Vec2 parameters(double t) const { return evaluate(p_curve_, t, 0)[0]; }
    /// Index of the patch that it runs on at t, on the side of its material.
    std::uint32_t patch_at(double t) const;
    /// Highest degree of that patch, in either parameter.
    int degree_at(double t) const;
    /// True for two of one trim curve, placed by one instance.
    bool is_same(const SurfaceCurve& other) const {
        return p_curve_.points.data() == other.p_curve_.points.data() &&
               transform_ == other.transform_;
    }
    /// Number of patches through which it may run.
    int patch_count() const { return 1 + grid_->lines_through(hull_bounds(p_curve_)); }
    /// Parameters between `begin` and `end`, begin < end, at which it passes from patch to patch,
    /// in rising order and exact to a few roundings. A patch that it enters and leaves between two
    /// of `2 patch_count() + 2` equal steps is missed.
    std::vector<double> patch_changes(double begin, double end) const;

private:
    struct Place;
    Place place(double t, int order) const;
    /// Speed, mm a unit of the parameter.
    double speed(double t) const;

    const SurfaceModel* model_;
    const PatchGrid* grid_;
    const Affine* transform_;
    BezierCurveView p_curve_;
    double side_;
};

} // namespace keiko
