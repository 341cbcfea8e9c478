#pragma once

#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/intersect/traversal/tracer.h"

namespace keiko {

/// A piece of a lamp's line that the eye sees, on one patch: lines end at the borders of patches.
struct SurfaceLine {
    std::uint32_t plane = 0;    ///< into the C-planes asked for
    std::uint32_t lamp = 0;     ///< of that plane, by rising v
    std::uint32_t instance = 0; ///< into SurfaceModel::instances
    std::uint32_t face = 0;     ///< into SurfaceModel::faces
    std::uint32_t patch = 0;    ///< into SurfaceModel::patches
    PatchLine line;             ///< world, mm
};

struct SurfaceLineOptions {
    LineLook look = LineLook::reflection;
    /// Of the body's size: how far apart on a line the eye's sight is asked for. What hides or cuts
    /// a shorter piece between two such places may be missed.
    double test_step = 1e-3;
    PatchLineOptions lines;
};

/// Every visible piece of the lines of all lamps on the trimmed surfaces of a model. A reflection
/// or highlight line belongs to the axis of its lamp; isophotes, of a plane with n lamps, to the
/// angles 90 (i + 1/2) / n degrees between normal and plane normal. `seen` holds all that may stand
/// in the way, of what the model's instances and patches come first in their order. The frame of
/// the picture cuts no line. Ordered by plane, lamp, instance and patch, the same for any thread
/// count. Throws Cancelled.
std::vector<SurfaceLine> surface_lines(const SurfaceModel& model, const Tracer& seen,
                                       std::span<const CPlane> planes, const Camera& camera,
                                       const SurfaceLineOptions& options = {}, const Job& job = {});

/// Sum of the chords, mm.
double length_of(const PatchLine& line);

} // namespace keiko
