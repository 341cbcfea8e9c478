#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/basics/placed_face.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// One panel in a section across a joint.
struct JointSide {
    PlacedFace face;      ///< of its skin
    Vec3 border{0};       ///< world, mm: where the skin ends
    Vec3 foremost{0};     ///< world, mm: the point of its edge that is nearest to the other panel
    double radius = 0;    ///< mm, of its edge; 0: sharp
    double curvature = 0; ///< 1/mm, of the skin's border, positive towards the other panel
};

/// A section across a joint between two panels, in the plane square to the mean direction of both
/// skins' borders (docs/theory/joints.md).
struct JointSection {
    std::array<JointSide, 2> sides; ///< of the panel with the lower number first
    Vec3 along{0};                  ///< unit normal of the plane
    Vec3 across{0};                 ///< unit, from the first panel to the second
    Vec3 outward{0};                ///< unit, away from both panels
    double gap = 0;                 ///< mm between the foremost points, along `across`
    double flush = 0;               ///< mm by which the second skin stands out, along `outward`
    double bound = 0;               ///< mm, error of gap, flush and places

    /// Middle between the foremost points, world, mm.
    Vec3 place() const { return (sides[0].foremost + sides[1].foremost) / 2; }
    /// mm, the smaller radius of both edges.
    double least_radius() const { return std::min(sides[0].radius, sides[1].radius); }
};

/// A place along a joint.
struct JointStation {
    std::uint32_t border = 0;            ///< of the first panel, into PanelBorders::all
    double t = 0;                        ///< parameter of that border
    Vec3 place{0};                       ///< there, world, mm
    double along = 0;                    ///< mm from the beginning of the joint
    std::optional<JointSection> section; ///< nullopt: it cannot be measured
};

/// Sections of a joint at which its quantities are extreme.
struct JointExtremes {
    JointSection widest, narrowest; ///< of the gap
    JointSection proudest, deepest; ///< of the flush
    JointSection sharpest;          ///< of the smaller radius of both edges
    double hidden_gap = 0;    ///< mm by which a gap between sections may be more extreme (estimate)
    double hidden_flush = 0;  ///< mm, of the flush
    double hidden_radius = 0; ///< mm, of the smaller radius
};

/// A stretch along which two panels stand apart, from a corner or an end to the next one.
struct Joint {
    std::vector<JointStation> stations;    ///< at least one, in order
    bool closed = false;                   ///< it ends at its beginning
    double length = 0;                     ///< mm, along the skin of the first panel
    double unmeasured = 0;                 ///< mm of that beside stations without a section
    Vec3 unmeasured_place{0};              ///< world, mm, the first of these
    std::array<PlacedFace, 2> faces{};     ///< of the skins, at the middle station
    std::string names;                     ///< of these: "face 12 (fender) | face 40 (door)"
    std::optional<JointExtremes> extremes; ///< nullopt if no section could be measured
};

} // namespace keiko
