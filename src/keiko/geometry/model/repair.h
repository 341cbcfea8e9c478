#pragma once

#include "keiko/base/export.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace KEIKO_API keiko {

/// Defect of a face in its file, and how it was repaired.
enum class RepairKind : std::uint8_t {
    p_curve_built,         ///< an edge had none on the surface: projected
    p_curve_approximated,  ///< of a kind that has no rational form
    p_curve_moved,         ///< by whole periods of the surface
    edges_sorted,          ///< of a wire whose order did not chain
    edge_reversed,         ///< it ran against its wire
    edge_dropped,          ///< inside or outside of the face: it bounds no material
    tiny_edge,             ///< shorter than its own tolerance; kept as it is
    degenerate_edge_added, ///< the side of the face at a pole was missing
    gap_bridged,           ///< gap between neighbouring edges, by a straight piece
    loop_closed,           ///< by a straight piece from its end to its begin
    point_loop_dropped,    ///< a loop that is only a point bounds nothing
    wire_split,            ///< one wire was several loops
    wire_reversed,         ///< both borders of a band ran the same way
    wire_around_closed,    ///< a wire once around the surface without a seam
    loop_doubled,          ///< across the seam of a closed surface
    loop_runs_backwards,   ///< material on its right; detected by nesting, not by direction
    surface_continued,     ///< loops leave its domain by a little
    loops_cut_off,         ///< loops leave the surface's domain by too much
    surface_approximated,  ///< it has no rational form
    by_reader              ///< a repair by the CAD reader, in its own words
};

/// "gap_bridged", ...
std::string_view name_of(RepairKind kind);
/// "gap between edges bridged", ...
std::string_view text_of(RepairKind kind);

/// All repairs of one kind on one face.
struct Repair {
    std::uint32_t face = 0;                    ///< Face::id
    RepairKind kind = RepairKind::gap_bridged; ///< what was repaired
    std::uint32_t count = 1;                   ///< how often
    double size = 0;                           ///< mm, of the largest; 0 where the kind has no size
    std::string detail;                        ///< the words of the CAD reader
};

} // namespace keiko
