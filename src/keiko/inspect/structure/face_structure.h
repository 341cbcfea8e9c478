#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/seams/model_borders.h"
#include "keiko/scene/criteria_preset.h"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace keiko {

/// How a placed spline face is put together from knot spans. Each value is measured, and judged, if
/// the limits have one for it.
struct SpanStructure {
    std::optional<MeasuredValue> degree;           ///< the larger of the two
    std::optional<MeasuredValue> spans;            ///< the larger number of the two directions
    std::optional<MeasuredValue> knot_distance;    ///< mm
    std::optional<MeasuredValue> patch_edge;       ///< mm; nullopt if all edges are points
    std::optional<MeasuredValue> degenerate_edge;  ///< mm
    std::optional<MeasuredValue> corner_angle;     ///< degrees; nullopt if no corner has two edges
    std::optional<MeasuredValue> width_ratio;      ///< nullopt if no direction has two spans
    std::optional<MeasuredValue> control_turn;     ///< degrees; nullopt if no row has two legs
    std::optional<MeasuredValue> control_twist;    ///< degrees; nullopt if all rows are points
    std::optional<MeasuredValue> control_ratio;    ///< nullopt if no row has two legs
    std::optional<MeasuredValue> control_distance; ///< mm; nullopt if all rows are points
};

/// True if the patches of a face are the knot spans of a spline surface of its file. Those of other
/// faces are Keiko's own.
bool has_spans(const Face& face);

/// Measures the spans that a face reaches into, as its instance places them
/// (docs/theory/structure.md). Requires has_spans.
SpanStructure span_structure(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                             const StructureLimits& limits);

/// An instance and a face of it, into the model's arrays.
using FaceKey = std::pair<std::uint32_t, std::uint32_t>;

/// The shortest edge of every placed face that has one, held to `limit` mm. An edge is what the
/// file has as one, on one side; edges that the file states to be points, and what closes loops
/// without an edge, are left out. Faces without loops have the sides of their domain that are not
/// points. Throws Cancelled.
std::map<FaceKey, MeasuredValue> shortest_edges(const ModelBorders& borders, double limit,
                                                const Job& job = {});

/// Size of a placed face held to `limit` mm: the diagonal of the box of five places on each of its
/// border curves. `place`: one of the face; nullopt if the face has no borders.
std::optional<MeasuredValue> face_size(const ModelBorders& borders, const FaceKey& face,
                                       const Vec3& place, double limit);

} // namespace keiko
