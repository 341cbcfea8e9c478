#include "keiko/visibility/boundaries/boundary_reach.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Bound of what a placement makes of a length.
double most_stretch(const Affine& placement) {
    double squares = 0;
    for (const Vec3& row : placement.rows) squares += row.length2();
    return placement.is_identity() ? 1 : std::sqrt(squares);
}

} // namespace

double boundary_reach(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face) {
    Box3 box;
    for (std::uint32_t i = 0; i < model.faces[face].patch_count; ++i)
        box.extend(hull_bounds(model.patch(model.faces[face].first_patch + i)));
    const Box3 placed = transformed(model.instances[instance].transform, box);
    // Of the face, more than leaves overlap by and go on past its ends; of the coordinates.
    constexpr double overlap = 1e-10, rounding = 1e-14;
    return overlap * placed.size() + rounding * placed.center().length();
}

double boundary_reach(const SurfaceModel& model, const Tracer& tracer, std::uint32_t instance,
                      std::uint32_t face, std::uint32_t trim_curve) {
    const double seam =
        tracer.seam_width(trim_curve) * most_stretch(model.instances[instance].transform);
    return std::max(seam, boundary_reach(model, instance, face));
}

} // namespace keiko
