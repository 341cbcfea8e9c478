#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/triage/mending.h"
#include "keiko/triage/standing_eyes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace keiko {

/// Findings that are one fault wherever they lie: those of one stretch, those of one face that ask
/// for the same mending, those of lines over what has no other finding, or an opening.
struct FaultUnit {
    std::uint32_t seam = no_index;     ///< stretch, into Inspection::seams
    std::uint32_t face = no_index;     ///< into Inspection::faces
    Mending mending = Mending::layout; ///< the first that its stretch or face needs
    bool jumps = false;                ///< one of its findings is a jump of curvature
    std::vector<std::size_t> findings; ///< for numbered_check(), rising
    Sight sight;                       ///< empty at first

    /// True for a jump of curvature whose change of stripes no eye resolves, as beside a fillet
    /// that is tangent to its neighbours.
    bool is_fine() const;
};

/// True for a finding of lines of lamps, which belongs to neither a stretch nor a face.
bool is_of_lines(const Check& check);

/// All findings of an inspection and its openings, each in one unit. Findings of lines belong to
/// the nearest stretch with findings between the same faces.
std::vector<FaultUnit> fault_units(const Inspection& inspection);

} // namespace keiko
