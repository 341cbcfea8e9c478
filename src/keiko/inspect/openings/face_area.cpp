#include "keiko/inspect/openings/face_area.h"

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/placed_face.h"

namespace keiko {

double rough_area(const SurfaceModel& model, const PlacedFace& of) {
    constexpr int cells = 8;
    const Face& face = model.faces[of.face];
    const TrimRegion trims(model, face);
    double area = 0;
    for (std::uint32_t k = 0; k < face.patch_count; ++k)
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j) {
                const std::uint32_t patch = face.first_patch + k;
                const Vec2 uv((i + 0.5) / cells, (j + 0.5) / cells);
                if (!trims.untrimmed() && !trims.contains(model.face_parameters(patch, uv)))
                    continue;
                const SurfaceDerivatives s = placed_derivatives(model, of.instance, patch, uv);
                area += s.du().cross(s.dv()).length() / (cells * cells);
            }
    return area;
}

} // namespace keiko
