#pragma once

#include "keiko/base/job.h"
#include "keiko/math/bounds.h"

namespace keiko {

struct SurfaceModel;

/// The box of the material: of all placed faces, as far as their trim loops leave them; world, mm.
/// Empty where there is none. It holds every place of the material, to within rounding (1e-14 of
/// the coordinates), and each of its sides is within 1e-8 of its size of one of them. Both are
/// proved by branch and bound, where a million parts suffice for a side; else only the former.
/// A trim curve counts where material lies beside it, tested at less than a thousandth of a piece
/// of it. Throws Cancelled. The same bits for any thread count.
Box3 material_bounds(const SurfaceModel& model, const Job& job = {});

} // namespace keiko
