#pragma once

#include "keiko/inspect/face_grid.h"

#include <optional>

namespace keiko {

/// A wave as a line on a face shows it.
struct WaveSection {
    double depth = 0;  ///< mm, from the form to a crest or a trough, positive for a crest
    double length = 0; ///< mm, of the wave
    double bound = 0;  ///< mm, by how much `depth` changes with a length that is 5 % shorter
    Vec2 place{0};     ///< in the grid
    Vec3 position{0};  ///< world, mm
};

/// Measures the wave of about `length` mm whose crest (`crest`) or trough lies at about `place`,
/// along the line of constant v (`along_u`) or of constant u. By second differences over half a
/// wave and a whole one, in which the bend of the form, up to its third derivative, cancels
/// (docs/theory/inspection.md). Nothing where the face ends within a wave of the place.
std::optional<WaveSection> wave_section(const FaceGrid& grid, const Vec2& place, bool along_u,
                                        bool crest, double length);

} // namespace keiko
