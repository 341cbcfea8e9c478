#include "keiko/workflow/shadow_casters.h"

#include <algorithm>
#include <cstddef>

namespace keiko {

SurfaceModel without(SurfaceModel model, const std::vector<bool>& faces) {
    for (std::size_t i = 0; i < model.faces.size(); ++i)
        if (faces[i]) model.faces[i].patch_count = model.faces[i].loop_count = 0;
    std::erase_if(model.irregular_patches,
                  [&](const IrregularPatch& patch) { return faces[patch.face]; });
    return model;
}

Occluders occluders_without(const SurfaceModel& model, const Tracer& tracer,
                            const std::vector<bool>& faces, const Job& job) {
    if (std::find(faces.begin(), faces.end(), true) == faces.end()) return {model, tracer, job};
    return {without(model, faces), tracer.without(faces), job};
}

} // namespace keiko
