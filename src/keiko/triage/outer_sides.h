#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/triage/standing_eyes.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace keiko {

/// A place of the surface that stands for some of its area.
struct AreaSample {
    Vec3 place{0};   ///< world, mm
    Vec3 normal{0};  ///< unit, along du x dv
    double area = 0; ///< mm2
};

/// The outer side of the largest skin of a body: that to which it bulges. A panel is an open sheet,
/// and its file may call either side of each face outward (docs/theory/triage.md).
class OuterSides {
public:
    /// A skin goes on over seams that turn by less than 60 degrees. It has no outer side if parts
    /// of it bulge to either side, or if the views see less than half as much of it from there as
    /// from the other side. Smaller skins have none.
    OuterSides(const SurfaceModel& model, const Inspection& inspection, const StandingEyes& eyes);

    /// True for a face of the largest skin, even if that has no outer side.
    bool hold(const PlacedFace& face) const;
    /// Unit, towards the outer side, of a face with the unit normal `normal` along its du x dv in
    /// the world; 0 without an outer side.
    Vec3 outward(const PlacedFace& face, const Vec3& normal) const;
    /// Unit, towards the outer side, of a face somewhere near `place`, world, mm; 0 without one.
    Vec3 outward_near(const PlacedFace& face, const Vec3& place) const;

private:
    struct SidedFace {
        double side = 0; ///< 1 if du x dv points outwards, -1 if inwards; 0: no outer side
        std::vector<AreaSample> samples;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, SidedFace> faces_; ///< by instance and face
};

} // namespace keiko
