#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/basics/line_field.h"
#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/inspect/lines/line_sources.h"
#include "keiko/intersect/traversal/tracer.h"

#include <cstdint>
#include <vector>

namespace KEIKO_API keiko {

/// The field of one source of lines and its levels, one a lamp. Isophotes have a level of either
/// sign, lamp by lamp, as the normal of a patch may point away from the viewpoint.
struct LampLevels {
    LineSource source;          ///< whose lines they are
    LineField field;            ///< of its C-plane
    std::vector<double> levels; ///< of the field
    std::uint32_t lamps = 0;    ///< of the C-plane

    /// Value of the field on the line of a lamp, with the normal towards the viewpoint.
    double level(std::uint32_t lamp) const { return levels[lamp]; }
    /// Distance between the levels of neighbouring lamps: the pitch, or for isophotes the step of
    /// the cosine; 0 for a single lamp.
    double step(std::uint32_t lamp) const;
};

/// Levels of all lamps. For reflection and highlight lines they are the lamps' axes, mm; for the
/// isophotes of n lamps the cosines of 90 (i + 1/2) / n degrees.
LampLevels lamp_levels(LineLook look, const LineEye& eye, const LineSource& source,
                       const Vec3& body);

/// A piece of a lamp's line on one patch that is visible from the viewpoint. Lines end at the
/// borders of patches.
struct SurfaceLine {
    std::uint32_t plane = 0;    ///< index of a requested source
    std::uint32_t lamp = 0;     ///< of that source, by rising v
    std::uint32_t instance = 0; ///< into SurfaceModel::instances
    std::uint32_t face = 0;     ///< into SurfaceModel::faces
    std::uint32_t patch = 0;    ///< into SurfaceModel::patches
    PatchLine line;             ///< world, mm
};

/// Options of surface_lines.
struct SurfaceLineOptions {
    LineLook look = LineLook::reflection; ///< kind of the lines
    /// Distance between visibility tests on a line, as a share of the body's size. An occluder or
    /// trim of a shorter piece between two tests may be missed.
    double test_step = 1e-3;
    PatchLineOptions lines; ///< of the search on each patch
};

/// Every visible piece of the lines of all lamps on the trimmed surfaces of a model. A reflection
/// or highlight line belongs to the axis of its lamp or to an edge of a panel. Isophotes of a plane
/// with n lamps belong to the angles 90 (i + 1/2) / n degrees between normal and plane normal.
/// `seen` holds all possible occluders; the model's instances and patches come first in it, in
/// their order. The frame of the picture cuts no line. Pieces are ordered by plane, lamp, instance
/// and patch, the same for any thread count. Throws Cancelled.
std::vector<SurfaceLine> surface_lines(const SurfaceModel& model, const Tracer& seen,
                                       std::span<const LineSource> sources, const Camera& camera,
                                       const SurfaceLineOptions& options = {}, const Job& job = {});

/// Sum of the chords, mm.
double length_of(const PatchLine& line);

} // namespace keiko
