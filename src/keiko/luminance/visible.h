#pragma once

#include "keiko/math/interval_set.h"
#include "keiko/math/vec.h"

#include <utility>

namespace keiko {

/// From a to b, mm; its points are a + t (b - a), t in [0, 1].
struct Segment {
    Vec3 a{0}, b{0};

    Vec3 at(double t) const { return a + (b - a) * t; }
};

/// What can be seen of a segment from one apex. The one question of visibility that lamps
/// (apex: surface point, segment: lamp axis) and light shafts (apex: light, segment: view ray)
/// both ask; the core knows neither surfaces nor ray tracing.
class Visible {
public:
    virtual ~Visible() = default;
    /// Parameters t of the segment that the apex sees.
    virtual IntervalSet intervals(const Segment& segment) const = 0;
};

/// Nothing stands in the way.
class AllVisible final : public Visible {
public:
    IntervalSet intervals(const Segment&) const override { return IntervalSet::whole(); }
};

} // namespace keiko
