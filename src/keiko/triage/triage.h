#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/inspection.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/triage/mending.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// One fault of a body: findings that are mended together.
struct TriageItem {
    Mending mending = Mending::layout; ///< the first that its worst part needs
    std::vector<std::size_t> findings; ///< for numbered_check(): the worst, then the others, rising
    std::vector<std::uint32_t> seams;  ///< stretches that show it, those of the most weight first
    std::uint32_t face = no_index;     ///< of the worst finding, if that is of a face
    std::uint32_t patch = no_index; ///< the face to rebuild, if most of its seams are the fault's
    double length = 0;              ///< mm, of all stretches
    /// Degrees that are left where a crease ends that fades at the worst stretch; else 0.
    double left_of_crease = 0;
    double visible = 0; ///< share of the length that at least one view shows
    double width = 0;   ///< arc minutes: the widest break of a lamp's reflection in the view below
    double weight = 0;  ///< arc minutes: breaks as they count, pooled over the length in that view
    std::string view;   ///< standing view that shows most of it
    bool mirrored = false; ///< it is on both sides of the body's middle plane
    Vec3 place{0};         ///< where it is seen best, on the first of its parts; world, mm
    bool torn = false;     ///< the width is that of a tear; else a stripe's width changes by it
    bool fine = false;     ///< jumps of curvature whose changes of stripes no eye resolves
};

/// The findings of a body in the order in which they are to be mended.
struct Triage {
    /// By falling weight, then as put_fine_among_first() leaves them.
    std::vector<TriageItem> items;
    std::vector<TriageItem> hidden; ///< at most a hundredth of the length is visible; by weight
};

/// Largest number of faults on the first screen of a report.
constexpr std::size_t most_shown = 7;

/// Moves the jumps that no eye resolves up to the end of the first `most_shown` faults, if most
/// stretches with faults are among them: they ask for a decision about the design.
void put_fine_among_first(std::vector<TriageItem>& faults);

/// Groups the findings of an inspection and orders the groups by what an eye sees of them in the
/// standing views (docs/theory/triage.md). Openings are among them, though they are not judged.
/// `tracer`: of the model. `ground`: z of the floor on which the viewers stand, mm; none: as of
/// Framing. Throws Cancelled.
Triage triage(const SurfaceModel& model, const Tracer& tracer, const Inspection& inspection,
              std::optional<double> ground, const Job& job = {});

} // namespace keiko
