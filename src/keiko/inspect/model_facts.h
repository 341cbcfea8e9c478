#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/seams/model_borders.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/bounds.h"

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Statistics of a model's ray tracer. Except for the time, they are the same for every run and
/// thread count.
struct TraceFacts {
    std::size_t sub_patches = 0;       ///< placed pieces of patches that rays are tested against
    std::size_t mixed_sub_patches = 0; ///< those of them that trim curves cut
    std::size_t trimmed_away_sub_patches = 0; ///< left out, since trimming removes all of them
    std::size_t bytes = 0; ///< of Keiko's own records, without Embree's box hierarchy
    std::optional<double> build_milliseconds{}; ///< nullopt where not timed
};

/// Facts without the time, which differs from run to run.
TraceFacts trace_facts(const TracerStatistics& statistics);
/// Facts of a tracer with the time that its build took.
TraceFacts timed_trace_facts(const TracerStatistics& statistics);

/// A part of a model file.
struct PartFacts {
    std::string name;                   ///< or empty
    std::size_t faces = 0, patches = 0; ///< number of each
    /// How often it is placed, and how often mirrored.
    std::size_t instances = 0, mirrored_instances = 0;
};

/// A face of a model file.
struct FaceFacts {
    std::uint32_t id = 0;                  ///< as Face::id
    std::uint32_t part = 0;                ///< index of its part, from 0
    std::string name, layer, surface_kind; ///< or empty
    std::optional<Rgb> color;              ///< as the file has it
    std::size_t patches = 0, loops = 0;    ///< number of each
    std::array<int, 2> degree{};           ///< the largest of its patches, u and v
    bool rational = false;                 ///< one of its patches, at least
    double approximated = 0;               ///< as Face::approximated
    std::uint32_t line = 0;                ///< as Face::line
    std::uint32_t file = 0;                ///< into ModelFacts::files
};

/// Number of remarks of each severity from the import; a lost face is an error.
struct RemarkCounts {
    std::size_t notes = 0, warnings = 0, errors = 0; ///< number of each
};

/// All repairs of one kind in a file.
struct RepairTotal {
    std::size_t count = 0, faces = 0; ///< of repairs, and of faces with any
    double size = 0;                  ///< mm, of the largest
};

/// Summary of a model file.
struct ModelFacts {
    std::string source, format;     ///< path and format of the file
    std::vector<std::string> files; ///< as files_of
    std::string unit;               ///< of the file; empty: it names none and is read as mm
    std::optional<double> millimetres_per_unit; ///< nullopt for an unknown unit
    /// Number of each; `faces` as stored, `placed_faces` as placed.
    std::size_t parts = 0, instances = 0, faces = 0, placed_faces = 0;
    std::vector<PartFacts> part_list;                  ///< in the order of the model
    std::vector<FaceFacts> face_list;                  ///< in the order of the model
    std::size_t patches = 0, trimmed_faces = 0;        ///< number of each
    std::size_t rational_patches = 0;                  ///< with weights that differ
    std::size_t approximated_faces = 0;                ///< whose patches are no exact conversion
    double largest_approximation = 0;                  ///< mm
    std::map<std::string, std::size_t> kinds;          ///< faces of each surface kind
    std::map<std::array<int, 2>, std::size_t> degrees; ///< patches of each degree u x v
    Box3 bounds;                                       ///< world, mm, of the material
    std::size_t edges = 0, degenerate_edges = 0; ///< as the file shares them; the latter are points
    double largest_edge_tolerance = 0;           ///< mm, as the file claims
    std::size_t seams = 0;    ///< lines along which faces meet, or one breaks; 0 where not measured
    double join = 0;          ///< mm, within which two borders count as a seam
    double border_length = 0; ///< mm, of all borders of all placed faces
    double free_length = 0;   ///< mm, of free edges
    std::vector<LostFace> lost_faces;                ///< faces that could not be converted
    std::vector<Repair> repairs;                     ///< one a face and kind, by face
    std::map<RepairKind, RepairTotal> repair_totals; ///< those of `repairs`, by kind
    Diagnostics diagnostics;                         ///< other remarks of the import
    RemarkCounts remarks;                            ///< of the diagnostics and the lost faces
    std::optional<TraceFacts> tracing;               ///< if a tracer was built
};

/// Summary of a model. `seams`: those of pair_seams for `join` mm.
ModelFacts model_facts(const ModelBorders& borders, std::span<const Seam> seams, double join,
                       const Job& job = {});

} // namespace keiko
