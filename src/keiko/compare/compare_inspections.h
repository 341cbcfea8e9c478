#pragma once

#include "keiko/inspect/inspection.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// Knobs of compare_inspections.
struct CompareOptions {
    double place = 10;   ///< mm: seams whose middles are further apart are not the same seam
    double gap = 1e-4;   ///< mm: a smaller change of a gap is none
    double angle = 1e-3; ///< degrees: a smaller change of an angle is none
};

/// One seam in two revisions of a part.
struct SeamChange {
    std::uint32_t before = 0, after = 0; ///< into the seams of the two inspections
    double gap = 0;                      ///< mm, after - before
    double angle = 0;                    ///< degrees, after - before; 0 where either has none
    Verdict verdict_before = Verdict::pass, verdict_after = Verdict::pass;
};

/// What became of the seams and findings of a part from one revision to the next.
struct InspectionDifference {
    std::vector<SeamChange> changed;    ///< beyond the tolerances, or in verdict
    std::vector<std::uint32_t> removed; ///< seams of the former without a partner
    std::vector<std::uint32_t> added;   ///< seams of the latter without a partner
    std::vector<Check> new_findings;    ///< of the latter, that the former did not have
    std::vector<Check> solved_findings; ///< of the former, that the latter does not have
    std::size_t matched = 0;            ///< seams found in both

    bool empty() const {
        return changed.empty() && removed.empty() && added.empty() && new_findings.empty() &&
               solved_findings.empty();
    }
};

/// Matches seams by the names of their faces and by place, names first, nearest first, each once.
/// A finding is new where the seam's partner has none of the same code.
InspectionDifference compare_inspections(const Inspection& before, const Inspection& after,
                                         const CompareOptions& options = {});

} // namespace keiko
