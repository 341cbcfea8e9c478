#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/math/bounds.h"

namespace KEIKO_API keiko {

struct SurfaceModel;

/// The box of the material, world, mm: all placed faces within their trim loops. It is empty if
/// there is no material. Two facts are proved by branch and bound. No place of the material lies
/// outside, beyond rounding (1e-14 of the coordinates). Each side of the box is within 1e-8 of the
/// box's size of a place of the material; this one is not proved for a side that takes more than
/// 200000 cuts. A trim curve counts as material where material lies beside it; that is tested at
/// places closer than a thousandth of the curve. The bits are the same for any thread count. Throws
/// Cancelled.
Box3 material_bounds(const SurfaceModel& model, const Job& job = {});

} // namespace keiko
