#pragma once

#include "keiko/inspect/flaws/face_adjacency.h"

#include <optional>

namespace keiko {

/// A wave on a straight trace over a surface.
struct WaveSection {
    double depth = 0;  ///< mm, from the form to a crest or a trough
    double length = 0; ///< mm, of the wave
    double bound = 0;  ///< mm: change of `depth` with a length that is 5 % shorter
    SheetPoint at;
    Vec3 position{0}; ///< world, mm
};

/// Measures the wave of about `length` mm whose crest (`crest`) or trough lies at about `at`, along
/// a straight trace in the direction `along`. It uses fourth differences over two waves around the
/// place or, where the surface ends, to one side (docs/theory/inspection.md). nullopt if there are
/// less than two waves.
std::optional<WaveSection> wave_section(const FaceAdjacency& faces, const SheetPoint& at,
                                        const Vec3& along, bool crest, double length);

} // namespace keiko
