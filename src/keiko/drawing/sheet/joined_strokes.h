#pragma once

#include "keiko/drawing/curves/model_curve.h"

#include <vector>

namespace keiko {

/// A part of a curve in one view, visible or hidden as a whole.
struct Stroke {
    CurveKind kind = CurveKind::edge; ///< of its curve
    bool visible = true;              ///< nothing lies before it
    std::vector<Vec2> points{};       ///< in the image of ImageProjection
};

/// Strokes of one kind, and alike visible or hidden, that end where others begin as one, so that a
/// line is one path and its dashes run on. By kind, visible ones first.
std::vector<Stroke> joined_strokes(const std::vector<Stroke>& strokes);

} // namespace keiko
