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

/// What can be seen of a segment from one apex. The one question of visibility that lamps
/// (apex: surface point, segment: lamp axis) and light shafts (apex: light, segment: view ray)
/// both ask; the core knows neither surfaces nor ray tracing.
class Visible {
public:
    virtual ~Visible() = default;
    /// Parameters t of the segment that the apex sees.
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
    virtual std::vector<std::optional<bool>> seen_as_whole(std::span<const Prism> prisms) const {
        return std::vector<std::optional<bool>>(prisms.size());
    }
};

/// Nothing stands in the way.
class AllVisible final : public Visible {
public:
    using Visible::intervals;
    IntervalSet intervals(const Segment&) const override { return IntervalSet::whole(); }
    std::vector<std::optional<bool>> seen_as_whole(std::span<const Prism> prisms) const override {
        return std::vector<std::optional<bool>>(prisms.size(), true);
    }
};

} // namespace keiko
