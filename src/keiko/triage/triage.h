#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/inspection.h"
#include "keiko/intersect/traversal/tracer.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Kinds of mending, by the property of the surface that is at fault.
enum class Mending {
    position,  ///< borders that do not meet
    tangent,   ///< a jump of the normal
    curvature, ///< a jump of the curvature, a dent or a wave
    layout     ///< the structure of patches and faces
};

/// "position", "tangent", "curvature", "layout"
std::string_view name_of(Mending mending);

/// One fault of a body: findings that are mended together.
struct TriageItem {
    Mending mending = Mending::layout; ///< what its worst finding asks for
    std::vector<std::size_t> findings; ///< into the inspection's findings, the worst first
    std::vector<std::uint32_t> seams;  ///< stretches that show it, those seen most first
    std::uint32_t face = no_index;     ///< of a fault of one face
    double length = 0;                 ///< mm, of all stretches
    double visible = 0;                ///< share of the length that at least one view shows
    double width = 0;      ///< arc minutes: the widest break of a lamp's reflection in any view
    double weight = 0;     ///< square arc minutes: that width over the length, in the view below
    std::string view;      ///< standing view that shows most of it
    bool mirrored = false; ///< it is on both sides of the body's middle plane
    Vec3 place{0};         ///< where it is seen best, on the stretch that is seen most; world, mm
};

/// The findings of a body in the order in which they are to be mended.
struct Triage {
    std::vector<TriageItem> items;  ///< those of the largest weight first
    std::vector<TriageItem> hidden; ///< at most `hidden_share` of the length is visible; the same
                                    ///< order
};

/// Share of a fault's length up to which it counts as hidden.
constexpr double hidden_share = 0.01;

/// Groups the findings of an inspection and orders the groups by what an eye sees of them in the
/// standing views (docs/theory/triage.md). Findings of one seam are one item. So are stretches of
/// the same mending that continue each other, and those that are images of each other at the middle
/// plane of the body across y. Findings of one face that ask for the same mending are one item.
/// Findings of lines belong to the nearest stretch with findings between the same faces. `tracer`:
/// of the model. `ground`: z of the floor on which the viewers stand, mm; none: the lowest z of the
/// body. Throws Cancelled.
Triage triage(const SurfaceModel& model, const Tracer& tracer, const Inspection& inspection,
              std::optional<double> ground, const Job& job = {});

} // namespace keiko
