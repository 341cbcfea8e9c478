#pragma once

#include "keiko/base/export.h"
#include "keiko/math/interval_set.h"
#include "keiko/math/vec.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Segment from a to b, mm; its points are a + t (b - a), t in [0, 1].
struct Segment {
    Vec3 a{0}, b{0}; ///< ends, world, mm

    /// Point at parameter t, 0 at a and 1 at b.
    Vec3 at(double t) const { return a + (b - a) * t; }
    bool operator==(const Segment&) const = default;
};

/// The parallel edges of a prism.
using Prism = std::array<Segment, 4>;

/// Rule that selects the slices at outlines across a prism that matter to lines along it.
struct TurnRule {
    double spacing = 1; ///< between the lines, of the prism's width
    double missed = 0;  ///< largest part of the whole prism that all omitted ones together may hide
                        ///< between lines
};

/// A place across a prism where the visible part of its lines may have a jump or a kink. There the
/// outline of an occluder begins, ends or turns back, runs along it, or leaves it by its ends.
struct CriticalSlice {
    Vec3 way{0};       ///< from the viewpoint, at right angles to the prism
    double missed = 0; ///< part of the prism that lines one spacing apart may miss without
                       ///< knowledge of it
    /// The side of it that is dark, by rising angle about the prism's direction: 1 or -1, or 0 if
    /// unknown.
    int dark = 0;
    bool jump = true; ///< the hidden part may jump there; otherwise only its rate may
};

/// Visible parts of segments from one viewpoint: the contract between lamps, light shafts and every
/// occlusion algorithm. Lamps query the lamp axis from a surface point, light shafts the camera ray
/// from a light. The contract knows neither surfaces nor ray tracing.
class Visibility {
public:
    virtual ~Visibility() = default;
    /// Parameters t of the segment that are visible from the viewpoint.
    virtual IntervalSet intervals(const Segment& segment) const = 0;
    /// Visible parameters of several segments at once, which costs less if they are parallel.
    virtual std::vector<IntervalSet> intervals(std::span<const Segment> segments) const {
        std::vector<IntervalSet> all;
        for (const Segment& segment : segments) all.push_back(intervals(segment));
        return all;
    }
    /// Visibility of whole prisms: true for a prism proved visible, false for one proved hidden,
    /// nullopt if neither is proved. The part of it below the horizon of the point does not count.
    virtual std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const {
        return std::vector<std::optional<bool>>(prisms.size());
    }
    /// Known places where the visible part of the lines along a prism may jump or kink.
    virtual std::vector<CriticalSlice> turns(const Prism&, const TurnRule&) const { return {}; }
};

/// Visibility without any occluder.
class Unoccluded final : public Visibility {
public:
    using Visibility::intervals;
    IntervalSet intervals(const Segment&) const override { return IntervalSet::whole(); }
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const override {
        return std::vector<std::optional<bool>>(prisms.size(), true);
    }
};

} // namespace keiko
