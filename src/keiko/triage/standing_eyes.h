#pragma once

#include "keiko/intersect/traversal/tracer.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace keiko {

/// Names of the views in which faults are sought: those of a walking surfacer, and last the one
/// from above, which decides what is hidden and not what comes first.
constexpr std::array<std::string_view, 9> standing_views{"standing-front",
                                                         "standing-rear",
                                                         "standing-left",
                                                         "standing-right",
                                                         "standing-three-quarter-front-left",
                                                         "standing-three-quarter-front-right",
                                                         "standing-three-quarter-rear-left",
                                                         "standing-three-quarter-rear-right",
                                                         "top"};

/// Share of the weight of a finding, or of the length of one without weight, within Sight::spread.
constexpr double spread_share = 0.8;

/// A finding as the standing views show it.
struct Sight {
    double length = 0;  ///< mm, of the finding
    double visible = 0; ///< mm of it that at least one view shows
    /// Arc minutes: the widest break of a reflection in each view.
    std::array<double, standing_views.size()> width{};
    /// Whether that tears a stripe; else it changes the stripe's width.
    std::array<bool, standing_views.size()> torn{};
    /// Arc minutes: the widest tear that an eye is as sure of as of a break, in any standing view.
    double tear = 0;
    /// The widths of the tears that an eye is as sure of as of the breaks, pooled() over the length
    /// that each view shows.
    std::array<double, standing_views.size()> weight{};
    /// World, mm: in the best view the middle of the places that are nearly as bad as the worst.
    Vec3 place{0};
    /// mm: distance from `place` within which `spread_share` of the weight in the best view lies.
    double spread = 0;

    /// Adds what is seen of another part of the same finding. The place stays that of the first.
    void add(const Sight& other);
    /// The standing view that shows most of it; "top" if none but that shows anything; the first
    /// if none does.
    std::size_t best_view() const;
    /// Share of the length that at least one view shows.
    double visible_share() const { return length > 0 ? visible / length : 0; }
    /// True if at most a hundredth of the length is visible.
    bool is_hidden() const { return visible_share() <= 0.01; }
    /// True if a standing view shows a tear, or a change of a stripe's width that an eye resolves.
    bool is_resolved() const;
    /// True if it has more weight in its best view. What has weight from the top alone comes after
    /// all that has some in a standing view.
    bool is_worse_than(const Sight& other) const;
};

/// A place of a finding, and how a reflection breaks there.
struct SightPlace {
    Vec3 place{0};          ///< world, mm
    Vec3 normal{0};         ///< unit, of either side of the surface; 0 for a hidden place
    Vec3 along{0};          ///< unit, of the run of the finding; 0 for a place
    double length = 0;      ///< mm of it that the place stands for
    Vec3 outward{0};        ///< unit, towards the side that counts; 0: both do
    double gap = 0;         ///< mm
    double gap_angle = 0;   ///< degrees: the angle that the gap counts as
    double angle = 0;       ///< degrees
    double curvature_a = 0; ///< 1/mm, across the run, on one side; above 0 towards the normal
    double curvature_b = 0; ///< 1/mm, on the other
    /// 1/mm, along the run, above 0 towards the normal.
    double curvature_along = 0;
};

/// The eyes of the standing views about a body.
class StandingEyes {
public:
    /// Keeps a reference to the tracer, of the body. `ground`: z of the floor on which the viewers
    /// stand, mm; none: as of Framing.
    explicit StandingEyes(const Tracer& tracer, std::optional<double> ground = {});

    /// Sight of places that belong to one finding, in their order along it.
    Sight sight(std::span<const SightPlace> places) const;
    /// True for each place that at least one view shows on its outer side.
    std::vector<bool> shown(std::span<const SightPlace> places) const;
    /// The surface at a place, as the first view shows it that does; nullopt if none does.
    std::optional<Hit> seen(const Vec3& place) const;

private:
    std::vector<std::vector<bool>> visibility(std::span<const SightPlace> places) const;

    const Tracer& tracer_;
    std::array<Vec3, standing_views.size()> eyes_; ///< world, mm
};

} // namespace keiko
