#include "keiko/api/place.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"

#include <pybind11/stl/filesystem.h>

namespace py = pybind11;

namespace keiko::python {

ChosenRig::ChosenRig(const py::object& lamps) {
    if (lamps.is_none()) return;
    if (py::hasattr(lamps, "text"))
        rig = parse_rig(lamps.attr("text").cast<std::string>(), "rig");
    else
        file = path_of(lamps);
}

LightRig ChosenRig::of(const Scene& scene) const {
    if (file) return read_rig(*file);
    if (rig) return *rig;
    if (!scene.rig) throw FieldError("rig", "the scene has no lamps of its own");
    return *scene.rig;
}

void add_rigs(py::module_& module) {
    module.def("rig_of_file",
               [](const std::filesystem::path& file) { return rig_text(read_rig(file)); });
    module.def("rig_of_text",
               [](const std::string& text) { return rig_text(parse_rig(text, "rig")); });
}

} // namespace keiko::python
