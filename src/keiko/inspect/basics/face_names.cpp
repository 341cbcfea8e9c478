#include "keiko/inspect/basics/face_names.h"

#include <algorithm>

namespace keiko {

std::string placed_face_name(const SurfaceModel& model, std::uint32_t instance,
                             std::uint32_t face) {
    std::string text = model.describe(model.faces[face]);
    if (model.instances.size() < 2) return text;
    const std::string number = "instance " + std::to_string(instance + 1);
    const std::string& name = model.instances[instance].name;
    if (name.empty()) return text + " of " + number;
    const bool only = std::count_if(model.instances.begin(), model.instances.end(),
                                    [&](const Instance& i) { return i.name == name; }) == 1;
    return text + " of " + name + (only ? "" : ", " + number);
}

} // namespace keiko
