#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/seams/seam_steps.h"
#include "keiko/math/interval_set.h"

#include <array>
#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// The relation of the two sides of a seam at one place; world coordinates. Where the borders
/// diverge by more than `parallel_borders`, as those with teeth, curvatures and slopes are those
/// square to the mean of their directions.
struct SeamPoint {
    double t = 0, s = 0;         ///< parameters of the curves of the sides a and b
    Vec3 place{0};               ///< on side a
    double gap = 0;              ///< mm, to the nearest point of side b
    std::optional<double> angle; ///< degrees, 0 smooth to 180 folded back; needs both normals
    double signed_angle = 0;     ///< the angle, negative where the surface bends the other way
    double curvature_a = 0, curvature_b = 0; ///< 1/mm, across the seam, normals on one side
    double slope_a = 0, slope_b = 0;         ///< 1/mm2, of these curvatures in the direction from a
                                             ///< to b
    bool overlap = false; ///< one side lies on the other's material rather than apart from it
    bool stacked =
        false; ///< one side lies over the other, along the normals, rather than beside it
};

/// degrees; error of an angle between two evaluated normals.
constexpr double angle_rounding = 1e-10;

/// Evaluates a seam on its exact geometry.
class SeamProbe {
public:
    /// Probe of a paired seam.
    SeamProbe(const BoundaryCurves& curves, const Seam& seam)
        : SeamProbe(curves.curve(seam.a), {seam.a.begin, seam.a.end}, curves.curve(seam.b),
                    {seam.b.begin, seam.b.end}) {}
    /// The curves of both sides and the parameters that face each other.
    SeamProbe(const SurfaceCurve& a, const ParameterInterval& on_a, const SurfaceCurve& b,
              const ParameterInterval& on_b);

    /// Two lines that run alike on either side of a bend inside one face, `a` to the left of `b`.
    /// They have no gap. Their angle is the turn of the normal about them beyond what the
    /// curvatures of both sides explain over the distance between: 0 on any uniformly curved
    /// surface. It is the whole turn where a radius of curvature is smaller than that distance.
    /// Where the lines diverge by more than `parallel_borders`, as at a tip, curvatures and turn
    /// are those along the connection, not square to either line.
    static SeamProbe across_bend(const SurfaceCurve& a, const SurfaceCurve& b) {
        SeamProbe probe(a, {0, 1}, b, {0, 1});
        probe.bend_ = true;
        return probe;
    }

    /// The part of the seam between two of its points. The nearest point of side b is still
    /// searched along the whole seam.
    SeamProbe part(const SeamPoint& from, const SeamPoint& to) const;

    /// The seam without its ends at poles, `way` mm of each; nullopt if it has no such end. An end
    /// is at a pole if the parametrisation of a side all but collapses there: curvatures then
    /// depend on the last digits of a file.
    std::optional<SeamProbe> away_from_poles(double way) const;

    /// Parameter of side a at which the seam begins.
    double begin() const { return on_a_.begin; }
    /// Parameter of side a at which the seam ends.
    double end() const { return on_a_.end; }
    /// The parameters of side a, and those of side b that face them; the latter fall if b runs in
    /// the opposite direction.
    const ParameterInterval& on_a() const { return on_a_; }
    /// Parameters of side b that face those of side a.
    const ParameterInterval& on_b() const { return on_b_; }
    /// The seam at parameter t of side a; `s_guess` is the estimated parameter of side b that faces
    /// it.
    SeamPoint at(double t, double s_guess) const;
    /// The seam at parameter t of side a, with an estimate in proportion.
    SeamPoint at(double t) const;
    /// mm, of side a.
    double length() const { return a_.length(begin(), end(), changes_.a); }
    /// mm of side a between two of its parameters, from < to.
    double length(double from, double to) const;
    /// The point at parameter t of side a; world, mm.
    Vec3 place(double t) const { return a_.at(t).position; }
    /// Derivative of side a at parameter t, mm a unit of it; 0 where it is stationary. World.
    Vec3 run(double t) const { return a_.at(t).first; }
    /// Frame of side a at parameter t; nullopt where the curve is stationary or the surface
    /// singular.
    std::optional<BoundaryFrame> frame(double t) const { return a_.frame(t); }
    /// Direction in which side a runs out of the seam's end, or out of its begin, over a length;
    /// nullopt if none was given. World.
    std::optional<Vec3> run_out_of(bool at_end) const {
        if (!runs_out_) return std::nullopt;
        return (*runs_out_)[at_end ? 1 : 0];
    }
    /// Gives those directions: out of the begin and of the end.
    void set_runs_out(const std::array<Vec3, 2>& runs) { runs_out_ = runs; }
    /// A point halfway along, on side a; world, mm.
    Vec3 middle() const { return place((begin() + end()) / 2); }

    /// Places from begin to end in at least `least` steps, every patch change among them: between
    /// two of them all quantities are smooth. Between two patch changes there are at least as many
    /// as the higher of the degrees of both patches. Steps are even in length and in the parameters
    /// of either side, whichever needs the shorter ones (seam_steps).
    std::vector<SeamStep> steps(int least) const;
    /// Parameters of side a at which either side passes from one patch to the next, in rising
    /// order.
    std::vector<double> patch_changes() const;

private:
    /// True if the area that a unit of the parameters of a side covers is next to nothing at a
    /// point, compared with that at another point.
    bool collapses_towards(const SeamPoint& end, const SeamPoint& inside) const;
    /// The first point `way` mm from an end, at most in the middle.
    SeamPoint inside_of(bool at_end, double way) const;

    /// Places at which patches change, in rising order.
    struct PatchChanges {
        std::vector<double> a;        ///< those of side a: its parameters
        std::vector<SeamStep> either; ///< those of both sides
    };
    PatchChanges find_changes() const;
    void add_changes(const std::vector<double>& on_b, PatchChanges& changes) const;

    SurfaceCurve a_, b_;
    ParameterInterval on_a_, on_b_; ///< that of b runs backwards where begin > end
    ParameterInterval reach_b_;     ///< where the nearest point of side b is searched
    bool forward_;                  ///< side b runs in the direction of side a
    PatchChanges changes_;
    std::optional<std::array<Vec3, 2>> runs_out_;
    bool bend_ = false; ///< the sides belong to one surface, at a distance from each other
};

} // namespace keiko
