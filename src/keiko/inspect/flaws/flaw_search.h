#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/flaws/flaw.h"
#include "keiko/inspect/seams/seam_measure.h"
#include "keiko/scene/criteria_preset.h"

#include <span>
#include <vector>

namespace keiko {

/// The flaws of a model that are at least half as deep as the limit, waves all of them, dents for
/// sure from 0.9 of it, and from 1.7 where their middle lies beyond a border, by placed faces that
/// they are deepest on (instances outer, faces without patches left out), the deepest of each
/// first. They are followed over smooth seams and up to borders (docs/theory/inspection.md).
/// `searched`: a placed face, whether it is looked at. `limits`: one at least, by ascending
/// windows; a flaw that several of them see is told once, by the narrowest one that measures it.
/// `bound` of a depth is an estimate: by how much it changes when less around the flaw is looked
/// at. Throws Cancelled.
std::vector<std::vector<Flaw>> find_flaws(
    const SurfaceModel& model, std::span<const MeasuredSeam> seams, std::span<const Seam> pieces,
    const std::vector<bool>& searched, std::span<const WavinessLimit> limits, const Job& job = {});

} // namespace keiko
