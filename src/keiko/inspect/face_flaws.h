#pragma once

#include "keiko/inspect/worst.h"
#include "keiko/patch/surface_model.h"
#include "keiko/spec/criteria_preset.h"

#include <vector>

namespace keiko {

/// A dent, a bump or waves inside a face.
struct Flaw {
    enum class Kind { dent, bump, waves };
    Kind kind = Kind::dent;
    Worst depth;      ///< mm, how far the surface leaves the form around it
    double width = 0; ///< mm: between where it bends most the other way; of waves their length
};

/// The flaws of a placed face that are at least half as deep as the limit, the deepest first
/// (docs/theory/inspection.md). `bound` of a depth is an estimate: by how much it changes when less
/// around the flaw is looked at.
std::vector<Flaw> find_flaws(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                             const WavinessLimit& limit);

} // namespace keiko
