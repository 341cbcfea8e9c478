#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Seams of two revisions that run along each other: mostly one of each; several where one of them
/// divides what the other has in one.
struct SeamGroup {
    std::vector<std::uint32_t> before, after; ///< ascending, never empty
};

/// Which seams of two revisions belong together.
struct SeamMatching {
    std::vector<SeamGroup> groups;             ///< by the first of `before`
    std::vector<std::uint32_t> removed, added; ///< ascending: without a partner
};

/// Shorter than 0.01 mm: where a trim turns in a hook that another program may well leave out.
inline bool is_sliver(const MeasuredSeam& seam) {
    return seam.length < 0.01;
}

/// Pairs seams by where they run, each once. The first are those within a hundredth of `reach` (mm)
/// of each other all along, nearest first. Then come those whose faces have the same names, then
/// the nearest within `reach`. What is left over joins the pair that it runs along. Slivers are
/// left out.
SeamMatching match_seams(std::span<const MeasuredSeam> before, std::span<const MeasuredSeam> after,
                         double reach);

/// Knobs of compare_inspections.
struct CompareOptions {
    double place = 10; ///< mm: seams that run farther apart are not the same seam
    double gap = 1e-3; ///< mm: a smaller change of a gap is none
    /// Degrees: a smaller change of an angle is none. A border that has moved by 1e-3 mm on a bead
    /// of radius 12 mm turns as much.
    double angle = 5e-3;
    double curvature = 5e-3; ///< share of 1: a smaller change of a mismatch of curvature is none
};

/// State of a seam in one revision: the worst of a group.
struct SeamState {
    double gap = 0;                  ///< mm
    std::optional<double> angle;     ///< degrees
    std::optional<double> curvature; ///< mismatch by the preset's formula; none where nearly flat
    Verdict verdict = Verdict::pass; ///< the worst of the group
    double severity = 0;             ///< as MeasuredSeam
    Vec3 place{0};                   ///< where it is worst
};

/// Trend of a seam from one revision to the next.
enum class SeamTrend {
    better, ///< by verdict, else by severity
    worse,  ///< by verdict, else by severity
    other   ///< neither
};
/// "better", "worse", "other"
std::string_view name_of(SeamTrend trend);

/// One seam in two revisions of a part.
struct SeamChange {
    SeamGroup seams;                    ///< into the seams of the two inspections
    SeamState before, after;            ///< in the two revisions
    SeamTrend trend = SeamTrend::other; ///< by verdict, else by severity

    /// After - before; 0 where either has none.
    double gap() const { return after.gap - before.gap; }
    /// Degrees, after - before; 0 where either has none.
    double angle() const;
    /// Share of 1, after - before; 0 where either has none.
    double curvature() const;
};

/// Changes of the seams and findings of a part from one revision to the next.
struct InspectionDifference {
    /// Beyond the tolerances, or in verdict: worse seams first, by how much they have changed.
    std::vector<SeamChange> changed;
    std::vector<std::uint32_t> removed; ///< seams of the former without a partner
    std::vector<std::uint32_t> added;   ///< seams of the latter without a partner
    std::vector<Check> new_findings;    ///< of the latter, that the former did not have
    std::vector<Check> solved_findings; ///< of the former, that the latter does not have
    std::vector<Check> same_findings;   ///< of the latter, that the former had as well
    std::size_t matched = 0;            ///< seams of the former found in the latter

    /// True if nothing has changed.
    bool empty() const {
        return changed.empty() && removed.empty() && added.empty() && new_findings.empty() &&
               solved_findings.empty();
    }
};

/// Matches seams by where they run, see match_seams, and reports what changed of them. A finding is
/// new where no partner of its seam has one of the same code, unless the seam has not changed.
InspectionDifference compare_inspections(const Inspection& before, const Inspection& after,
                                         const CompareOptions& options = {});

} // namespace keiko
