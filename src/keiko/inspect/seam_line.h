#pragma once

#include "keiko/inspect/seam_measure.h"
#include "keiko/inspect/seam_probe.h"

#include <vector>

namespace keiko {

/// A line along which two sides meet, ready to be measured.
struct SeamLine {
    std::uint32_t instance_a = 0, face_a = 0, instance_b = 0, face_b = 0;
    std::vector<SeamProbe> probes; ///< piece after piece, at least one
};

/// Measures a line on the exact geometry and judges it. `pieces` of the result is empty.
MeasuredSeam measure_line(const SurfaceModel& model, const SeamLine& line,
                          const CriteriaPreset& preset);

} // namespace keiko
