#pragma once

#include "keiko/inspect/seams/class_stretches.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <vector>

namespace keiko {

/// A line along which two sides meet, prepared for measuring.
struct SeamLine {
    std::uint32_t instance_a = 0;  ///< of side a, into SurfaceModel::instances
    std::uint32_t face_a = 0;      ///< of side a, into SurfaceModel::faces
    std::uint32_t instance_b = 0;  ///< of side b, into SurfaceModel::instances
    std::uint32_t face_b = 0;      ///< of side b, into SurfaceModel::faces
    std::vector<SeamProbe> probes; ///< piece after piece, at least one
};

/// A stretch of a line, and the parts of the line's probes that it consists of.
struct MeasuredStretch {
    MeasuredSeam seam;           ///< without `faces`, `line` and `pieces`
    std::vector<SeamPart> parts; ///< in the order of the line's probes
};

/// The lengths and angles by which a preset cuts the lines between two faces of these sizes (mm)
/// into stretches. Negligible lengths are at most a hundredth of the smaller size.
StretchLimits stretch_limits(double size_a, double size_b, const CriteriaPreset& preset,
                             double join);

/// Cuts a line into stretches, measures each on the exact geometry and judges it by the rules of
/// its class, scraps too. `beyond`: of seam_stretches.
std::vector<MeasuredStretch> measure_line(const SurfaceModel& model, const SeamLine& line,
                                          const CriteriaPreset& preset, const StretchLimits& limits,
                                          const PiecesBeyond& beyond = {});

} // namespace keiko
