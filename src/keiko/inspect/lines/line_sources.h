#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/inspect/basics/line_field.h"
#include "keiko/light/rig/light_rig.h"

#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// Parallel straight lines of light in a plane, whose images on a surface are followed: the axes of
/// a row of tubes, or edges of panels.
struct LineSource {
    CPlane row;             ///< its lamps' axes are the lines
    bool of_panels = false; ///< they are edges
    bool one_sided = false; ///< they are visible from the side of u x v alone
    /// Normal of the face of another panel that begins at the edge: where that face shines, too, it
    /// goes on beyond the edge, which is none there.
    std::optional<Vec3> beyond{};

    /// The axes of a row of tubes.
    LineSource(const CPlane& tubes) : row(tubes) {}

    /// World positions of the ends of a line, mm; lines count from 0.
    Segment line(int number) const;
    /// True if the lines are edges of light as viewed from a place.
    bool is_visible_from(const Vec3& place) const;
};

/// The rows of tubes of a rig in order, then the edges of its panels. Parallel edges of panels in a
/// plane that begin at the same level and lie equally far apart, as those of a zebra screen, are
/// lines of one source. Between panels of the same luminance that shine the same way there is no
/// edge. Panels hide no edges of each other. Isophotes belong to rows of tubes alone.
std::vector<LineSource> line_sources(const LightRig& rig, LineLook look = LineLook::reflection);

} // namespace keiko
