#pragma once

#include "keiko/math/interval_set.h"
#include "keiko/math/vec.h"

#include <optional>

namespace keiko {

/// A straight piece of a polyline; world, mm.
struct Chord {
    Vec3 from{0}; ///< its begin
    Vec3 to{0};   ///< its end

    /// mm.
    double length() const { return (to - from).length(); }
    /// The point at a share of it, 0 at `from` and 1 at `to`.
    Vec3 at(double share) const { return from + (to - from) * share; }
};

/// The part of `chord` that runs beside `other`: from each of its places the foot of the
/// perpendicular on the line of `other` lies on `other`, at most `reach` mm away. Shares of
/// `chord`; nullopt if there is none, or if the chords diverge by more than `parallel_borders`.
std::optional<ParameterInterval> part_beside(const Chord& chord, const Chord& other, double reach);

} // namespace keiko
