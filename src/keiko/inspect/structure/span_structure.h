#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/scene/criteria_preset.h"

#include <cstdint>
#include <optional>

namespace keiko {

/// How a placed spline face is put together from knot spans. Each value is measured, and judged, if
/// the limits have one for it.
struct SpanStructure {
    std::optional<MeasuredValue> degree;          ///< the larger of the two
    std::optional<MeasuredValue> spans;           ///< the larger number of the two directions
    std::optional<MeasuredValue> knot_distance;   ///< mm
    std::optional<MeasuredValue> patch_edge;      ///< mm; nullopt if all edges are points
    std::optional<MeasuredValue> degenerate_edge; ///< mm
    std::optional<MeasuredValue> corner_angle;    ///< degrees; nullopt if no corner has two edges
};

/// True if the patches of a face are the knot spans of a spline surface of its file. Those of other
/// faces are Keiko's own.
bool has_spans(const Face& face);

/// Measures the spans that a face reaches into, as its instance places them
/// (docs/theory/structure.md). Requires has_spans.
SpanStructure span_structure(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                             const StructureLimits& limits);

} // namespace keiko
