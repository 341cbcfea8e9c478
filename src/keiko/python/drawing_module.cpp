#include "keiko/api/lines.h"
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/output_folder.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <string>
#include <vector>

namespace py = pybind11;

namespace keiko::python {
namespace {

HiddenLines hidden_named(const std::string& name) {
    if (name == "remove") return HiddenLines::remove;
    if (name == "dash") return HiddenLines::dash;
    if (name == "draw") return HiddenLines::draw;
    throw FieldError("hidden", "is remove, dash or draw, not " + name);
}

std::vector<std::string> layers_named(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        bool known = false;
        for (std::size_t kind = 0; kind < curve_kinds; ++kind)
            known = known || name == name_of(static_cast<CurveKind>(kind));
        if (!known) throw FieldError("without", "names no layer: " + name);
    }
    return names;
}

DrawOptions options_of(const py::dict& given) {
    DrawOptions options;
    options.views = taken<std::vector<std::string>>(given, "views");
    options.perspective = taken<bool>(given, "perspective");
    options.hidden = hidden_named(taken<std::string>(given, "hidden"));
    options.without = layers_named(taken<std::vector<std::string>>(given, "without"));
    options.join = options.curves.join = require_join(taken<double>(given, "join"));
    options.crease_angle = taken<double>(given, "crease");
    if (!(options.crease_angle >= 0 && options.crease_angle <= 180))
        throw FieldError("crease", "is not 0 to 180 degrees");
    for (const std::string& plane : taken<std::vector<std::string>>(given, "sections"))
        options.curves.planes.push_back(section_plane(plane));
    options.curves.iso_curves = taken<int>(given, "iso_curves");
    if (options.curves.iso_curves < 0 || options.curves.iso_curves > 100)
        throw FieldError("iso_curves", "is not 0 to 100");
    if (taken<bool>(given, "findings"))
        options.findings = preset_by_name_or_file(taken<std::string>(given, "preset"));
    options.paper = paper_size(taken<std::string>(given, "paper"));
    options.title = taken<std::string>(given, "title");
    return options;
}

Sheet drawing(const OpenScene& open, const py::object& rig, const py::dict& given,
              const py::object& progress, int threads) {
    DrawOptions options = options_of(given);
    if (!rig.is_none()) options.rig = ChosenRig(rig).of(*open.scene);
    return run({progress, threads},
               [&](const Job& job) { return draw_scene(*open.scene, options, job); });
}

py::dict layers_of(const Sheet& sheet) {
    py::dict layers;
    for (const SheetLayer& layer : sheet.layers) layers[py::str(layer.name)] = layer.lines.size();
    return layers;
}

} // namespace

void add_drawings(py::module_& module) {
    const auto svg = [](const Sheet& sheet) { return sheet_output(sheet, "sheet.svg"); };
    py::class_<Sheet>(module, "Drawing", "A sheet of line drawings. A notebook shows it.")
        .def_property_readonly("layers", &layers_of, "Number of lines in each layer, by its name.")
        .def("svg", svg, "Text of an SVG file.")
        .def("_repr_svg_", svg)
        .def(
            "dxf", [](const Sheet& sheet) { return py::bytes(sheet_output(sheet, "sheet.dxf")); },
            "Bytes of a DXF file.")
        .def(
            "pdf", [](const Sheet& sheet) { return py::bytes(sheet_output(sheet, "sheet.pdf")); },
            "Bytes of a PDF file.")
        .def(
            "write",
            [](const Sheet& sheet, const py::object& file) {
                const std::filesystem::path path = path_of(file);
                FileTransaction output;
                output.add(path, sheet_output(sheet, path));
                output.write();
            },
            py::arg("file"), "Writes an .svg, .dxf or .pdf file, by the ending of its name.");
    module.def("draw_sheet", &drawing);
}

} // namespace keiko::python
