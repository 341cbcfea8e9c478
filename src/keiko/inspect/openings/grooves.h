#pragma once

#include "keiko/inspect/openings/opening.h"
#include "keiko/inspect/seams/model_borders.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <span>
#include <vector>

namespace keiko {

/// Grooves between two faces that bend into flanges or walls. Their creases run side by side within
/// `limits.join` mm and more than `limits.gap` apart. The faces would continue each other, turning
/// by at most `feature_angle` degrees. No material closes the gap: neither face lies in it, and the
/// faces beyond the creases are wider than the join distance, no strips. One for each pair of
/// placed faces that have no seam with each other, if it is longer than `limits.from` mm; at its
/// widest. Creases of one and the same face beyond are left out. `pieces`: MeasuredSeams::pieces.
std::vector<Opening> grooves(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
                             std::span<const Seam> pieces, const OpeningLimits& limits,
                             double feature_angle);

} // namespace keiko
