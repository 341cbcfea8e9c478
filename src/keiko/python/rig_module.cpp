#include "keiko/api/place.h"
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

void add_rigs(py::module_& module) {
    module.def("rig_of_file",
               [](const std::filesystem::path& file) { return rig_text(read_rig(file)); });
    module.def("rig_of_text",
               [](const std::string& text) { return rig_text(parse_rig(text, "rig")); });
}

} // namespace keiko::python
