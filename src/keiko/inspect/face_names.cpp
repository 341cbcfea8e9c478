#include "keiko/inspect/face_names.h"

namespace keiko {

std::string placed_face_name(const SurfaceModel& model, std::uint32_t instance,
                             std::uint32_t face) {
    std::string text = model.describe(model.faces[face]);
    if (model.instances.size() < 2) return text;
    const std::string& name = model.instances[instance].name;
    return text + " of " + (name.empty() ? "instance " + std::to_string(instance + 1) : name);
}

} // namespace keiko
