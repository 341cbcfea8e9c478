#pragma once

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/import/cad/cad_import.h"

#include <TopoDS_Shape.hxx>

namespace keiko::cad {

/// A shape as a model of one part, placed once.
inline SurfaceModel converted(const TopoDS_Shape& shape) {
    CadDocument document;
    document.parts.push_back({shape, "part", {}});
    document.instances.push_back({0, "part", {}});
    return convert_document(document);
}

/// Area of the material of a face by midpoint sampling of its patches.
inline double area(const SurfaceModel& model, const Face& face) {
    constexpr int count = 120;
    const TrimRegion material(model, face);
    double sum = 0;
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) {
                const Vec2 uv((i + 0.5) / count, (j + 0.5) / count);
                if (!material.untrimmed() && !material.contains(model.face_parameters(p, uv)))
                    continue;
                const SurfaceDerivatives s = evaluate(model.patch(p), uv, 1);
                sum += s.du().cross(s.dv()).length() / (count * count);
            }
    return sum;
}

} // namespace keiko::cad
