#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/seams/seam_measure.h"
#include "keiko/scene/criteria_preset.h"

#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// A dent, a bump or waves of a surface, or that these are unknown.
struct Flaw {
    /// Form of a flaw.
    enum class Kind {
        dent,       ///< below the form around it
        bump,       ///< above the form around it
        waves,      ///< up and down along a line
        unsearched, ///< unknown: the face would take too many samples
        rough       ///< unknown: the face approximates one of the file too roughly
    };
    Kind kind = Kind::dent; ///< form of the flaw
    MeasuredValue depth;    ///< mm, deviation of the surface from the form around it
    double width = 0;       ///< mm: between the largest opposite curvatures; of waves their length;
                            ///< of what is not searched the size of the face
    double window = 0;      ///< mm, of the limit that it is judged by

    /// False if whether there is one is unknown.
    bool is_searched() const { return kind != Kind::unsearched && kind != Kind::rough; }
};

/// The flaws of a model that are at least half as deep as the limit, by the placed face on which
/// they are deepest, the deepest of each face first. Faces are in the order of instances, those
/// without patches left out. All waves of that depth are found. Dents are certain from 0.9 of the
/// limit, and from 1.7 if their middle lies beyond a border. Flaws are followed over smooth seams
/// and up to borders (docs/theory/inspection.md).
/// `searched`: for each placed face, true if it is searched. `limits`: at least one, by ascending
/// windows; a flaw of several windows is reported once, by the narrowest one that measures it.
/// `bound` of a depth is an estimate: its change when less of the surroundings is used, and what an
/// approximated face may be off. Throws Cancelled.
std::vector<std::vector<Flaw>> find_flaws(const SurfaceModel& model,
                                          std::span<const MeasuredSeam> seams,
                                          std::span<const Seam> pieces, std::vector<bool> searched,
                                          std::span<const WavinessLimit> limits,
                                          const Job& job = {});

} // namespace keiko
