#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/seam/seam.h"

#include <cstddef>
#include <vector>

namespace keiko {

/// mm, within which borders of a model meet as those of a closed body: a ten thousandth of its
/// size, at most 0.5 mm.
double closing_join(const SurfaceModel& model);

/// True if every border of a model's placed faces has one partner all along, up to 1 % of it. The
/// seams are those of pair_seams; borders shorter than `join` mm are points and need no partner.
bool borders_close(const SurfaceModel& model, double join, const Job& job = {});

/// The sets of faces of a model that seams of pair_seams connect, each by a number, one a face.
/// Numbers are those of the first faces of the sets.
std::vector<std::size_t> connected_faces(const SurfaceModel& model, double join,
                                         const Job& job = {});

} // namespace keiko
