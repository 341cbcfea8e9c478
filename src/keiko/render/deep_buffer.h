#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/vec.h"
#include "keiko/scene/camera.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace KEIKO_API keiko {

/// Rows of a picture at equal distances.
struct RowSet {
    int first = 0; ///< the uppermost, from 0 to `step` - 1
    int step = 1;  ///< rows from one to the next, at least 1

    /// Number of rows in a picture of that height.
    int count(int height) const { return first < height ? (height - first - 1) / step + 1 : 0; }
};

/// Passes over a picture, from coarse to fine: every 8th row, then those midway between, and so on.
/// Together they have each row once.
std::array<RowSet, 4> interlaced_rows();

/// The first surface on a ray. Normals are on the side that the ray comes from.
struct DeepSample {
    /// mm along the ray; infinite: no surface, and the other numbers are those of none.
    float t = std::numeric_limits<float>::infinity();
    float normal_x = 0, normal_y = 0; ///< octahedral() of the unit normal
    /// Second fundamental form along the axes across the normal, 1/mm, positive where the surface
    /// bends towards the normal. NaN where rounding leaves no curvature, as beside poles.
    float shape_xx = 0, shape_xy = 0, shape_yy = 0;
    /// mm along the reflected ray to the next surface; infinite: none.
    float way = std::numeric_limits<float>::infinity();
    /// Index of the face in the model plus 1; 0: no surface.
    float face = 0;

    /// The stored unit normal.
    Vec3 normal() const;
    /// The axes across the stored normal that the second fundamental form is stated along
    /// [Duff2017]. Which of two forms they have is decided by `|normal_x| + |normal_y| > 1` in
    /// single precision.
    std::array<Vec3, 2> axes() const;
};

/// A surface seen in mirrors: the first on a reflected ray.
struct DeepBounce {
    std::uint32_t pixel = 0; ///< y times the picture's width, plus x
    DeepSample sample;       ///< `t` is the `way` of the surface that reflects the ray
};

/// Options of deep_buffer.
struct DeepOptions {
    RowSet rows{}; ///< of the picture
    int reflections =
        3; ///< traced one after the other, 1 to 8; of the last only the `way` is known
};

/// Everything that the reflections of a picture depend on, lamps excepted: the surfaces on each
/// pixel's path, for relighting without tracing [Pellacini2005].
struct DeepBuffer {
    int width = 0, height = 0;       ///< pixels of the whole picture
    RowSet rows{};                   ///< those of the samples
    std::vector<DeepSample> samples; ///< of pixel centres, row by row
    std::vector<DeepBounce> bounces; ///< by pixel, then in the order of the reflections
};

/// Traces one camera ray a pixel, and the reflected rays from there. The same bytes for any thread
/// count, and for any rows that a pixel is traced with. Requires a tracer with second derivatives,
/// and options in their ranges. Throws Cancelled.
DeepBuffer deep_buffer(const Tracer& tracer, const Camera& camera, const DeepOptions& options = {},
                       const Job& job = {});

} // namespace keiko
