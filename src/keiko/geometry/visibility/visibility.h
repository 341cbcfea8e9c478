#pragma once

#include "keiko/math/interval_set.h"
#include "keiko/math/vec.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// From a to b, mm; its points are a + t (b - a), t in [0, 1].
struct Segment {
    Vec3 a{0}, b{0};

    Vec3 at(double t) const { return a + (b - a) * t; }
    bool operator==(const Segment&) const = default;
};

/// The parallel edges of a prism.
using Prism = std::array<Segment, 4>;

/// Which turns of outlines across a prism matter to lines that are looked at along it.
struct TurnRule {
    double gap = 1;    ///< between the lines, of the prism's width
    double missed = 0; ///< what all that are left out may hide between lines, of the whole prism
};

/// A place across a prism where what is seen of its lines may jump or bend: where the outline of
/// something before it begins, ends or turns back, runs along it, or leaves it by its ends.
struct CriticalSlice {
    Vec3 way{0};       ///< from the viewpoint, at right angles to the prism
    double missed = 0; ///< what lines a gap apart may miss of the prism if they know nothing of it
    /// The side of it that is dark, by rising angle about the prism's direction: 1 or -1, or 0
    /// where that is not known.
    int dark = 0;
    bool jump = true; ///< what is hidden may change at once there; else only how fast it does
};

/// What can be seen of a segment from one viewpoint. The one question of visibility that lamps
/// (viewpoint: surface point, segment: lamp axis) and light shafts (viewpoint: light, segment: view
/// ray) both ask; the core knows neither surfaces nor ray tracing.
class Visibility {
public:
    virtual ~Visibility() = default;
    /// Parameters t of the segment that the viewpoint sees.
    virtual IntervalSet intervals(const Segment& segment) const = 0;
    /// Of several segments at once, which costs less where they are parallel.
    virtual std::vector<IntervalSet> intervals(std::span<const Segment> segments) const {
        std::vector<IntervalSet> all;
        for (const Segment& segment : segments) all.push_back(intervals(segment));
        return all;
    }
    /// Of each prism, true where it is proved to be seen as a whole, false where nothing of it is,
    /// in both cases but for what of it lies below the horizon of the point; nothing where neither
    /// is proved.
    virtual std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const {
        return std::vector<std::optional<bool>>(prisms.size());
    }
    /// Where what is seen of the lines along a prism may change at once, as far as it is known.
    virtual std::vector<CriticalSlice> turns(const Prism&, const TurnRule&) const { return {}; }
};

/// Nothing stands in the way.
class Unoccluded final : public Visibility {
public:
    using Visibility::intervals;
    IntervalSet intervals(const Segment&) const override { return IntervalSet::whole(); }
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const override {
        return std::vector<std::optional<bool>>(prisms.size(), true);
    }
};

} // namespace keiko
