#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_curve.h"

#include <vector>

namespace KEIKO_API keiko {

/// Parameters of the curves of the sides a and b at one place of a seam.
struct SeamStep {
    double t = 0; ///< of side a
    double s = 0; ///< of side b
};

/// The course of one side of a seam: places so close that neither its length nor its path in the
/// parameters of its face goes far between two of them.
class SideCourse {
public:
    /// A place of the course. Sums are those of chords, from the begin of the course.
    struct Place {
        double t = 0;       ///< parameter of the curve
        Vec3 position{0};   ///< world, mm
        Vec2 parameters{0}; ///< of the face
        double length = 0;  ///< mm
        double path = 0;    ///< in the parameters of the face
    };

    /// The course from `begin` to `end`, in either order. From one place to the next go at most
    /// about 2 / `least` of its length and of its path; `least` is at least 1.
    SideCourse(const SurfaceCurve& curve, double begin, double end, int least);

    /// Places from the begin of the course to its end, at least two.
    const std::vector<Place>& places() const { return places_; }
    /// mm.
    double length() const { return places_.back().length; }
    /// Share of the length at a place, 0 to 1.
    double share(std::size_t place) const;
    /// Share of the length at a parameter, by straight lines between places.
    double share_at(double t) const;
    /// Parameter at a share of the length, by straight lines between places.
    double parameter_at(double share) const;

private:
    Place place_at(double t) const;
    void add(Place next);
    void refine(const Place& a, const Place& b, const Place& most, int halvings);

    const SurfaceCurve* curve_;
    std::vector<Place> places_;
};

/// Steps of a seam between places at which patches of either side end. `stops` are these places
/// and the ends of the seam, at least two. Between two stops the steps are even, but shorter
/// towards the stops, in each of these: the length, the parameters of both curves, and the paths in
/// the parameters of both faces. Where these differ, as unequal weights make them, a step is as
/// short as the densest requires. There are at least `least` steps in the whole length, and between
/// two stops at least as many as the degrees of both patches.
std::vector<SeamStep> seam_steps(const SurfaceCurve& a, const SurfaceCurve& b,
                                 const std::vector<SeamStep>& stops, int least);

} // namespace keiko
