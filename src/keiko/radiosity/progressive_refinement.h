#pragma once

#include "keiko/base/job.h"
#include "keiko/math/rgb.h"
#include "keiko/radiosity/energy_balance.h"
#include "keiko/radiosity/reflector.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace keiko {

/// Progressive refinement of the radiosities of elements: each step shoots the unshot light of the
/// element that has most of it to all others [Cohen1988]. Exchange areas are needed one row at a
/// time, and are not kept.
class ProgressiveRefinement {
public:
    /// Exchange areas of an element with all, in their order, mm2. May throw: nothing is shot then.
    using RowOf = std::function<std::vector<double>(std::size_t element)>;

    /// Areas in mm2, above 0, and one reflector each.
    ProgressiveRefinement(std::vector<double> areas, std::vector<Reflector> reflectors, RowOf row);

    /// Shoots once and returns the element that did. Elements whose unshot light is the same to
    /// 1e-9 shoot in their order. Call it only while unshot() has light.
    std::size_t shoot();
    /// Shoots until remaining() is at most `allowed`, or `most_steps` times, reporting progress.
    /// Returns the number of steps. Throws Cancelled, and then has what was found until then.
    int refine(double allowed, int most_steps, const Job& job = {});

    /// Radiosities found so far, lm/m2, without ambient light.
    std::vector<Rgb> radiosity() const;
    /// Light that has arrived at each element from the others, lx.
    const std::vector<Rgb>& arriving() const { return arriving_; }
    /// Light shot that no element has received, lm/m2 times mm2.
    const Rgb& escaped() const { return escaped_; }
    /// Balance of the light so far; what is missing has not been shot yet.
    EnergyBalance balance() const;
    /// Radiosities that still have to be shot, lm/m2.
    const std::vector<Rgb>& unshot() const { return unshot_; }
    /// Estimate of the light that has not yet arrived, lx on every element: the mean unshot
    /// radiosity over 1 minus the mean reflectance [Cohen1988].
    Rgb ambient() const;
    /// Radiosities with the reflected ambient estimate, lm/m2.
    std::vector<Rgb> with_ambient() const;
    /// Bound of the light that is missing in radiosity(), as a share of all that is in it: unshot
    /// light times q / (1 - q), where q is the largest reflectance. It is infinite if q is 1, and
    /// no number if light is none.
    double remaining() const;

private:
    std::size_t brightest() const;

    std::vector<double> areas_;
    std::vector<Reflector> reflectors_;
    RowOf row_;
    std::vector<Rgb> arriving_, unshot_;
    Rgb escaped_; ///< of the light shot, times mm2
};

} // namespace keiko
