#include "keiko/api/check.h"
#include "keiko/api/inspect.h"
#include "keiko/api/results.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// The JSON of a check, which Python reads.
std::string check(const py::object& input, const std::string& preset, double join,
                  const std::string& unit, const std::string& axes, const py::object& progress,
                  int threads) {
    const std::vector<std::filesystem::path> paths = paths_of(input);
    return run({progress, threads}, [&](const Job& job) {
        CheckOptions options;
        options.preset = preset_by_name_or_file(preset), options.join = join;
        options.load.unit = unit, options.load.axes = axes;
        return inspection_json(check_models(paths, options, job).inspection, version());
    });
}

/// A report as text and files.
struct ReportTexts {
    std::string json, html;
    InspectResult result;
};

ReportTexts inspect(const OpenScene& open, const std::string& preset, double join,
                    const std::vector<std::string>& views,
                    const std::optional<std::filesystem::path>& rig, const py::object& progress,
                    int threads) {
    return run({progress, threads}, [&](const Job& job) {
        InspectOptions options;
        options.preset = preset_by_name_or_file(preset), options.join = join;
        options.views = views, options.rig = rig;
        options.picture = picture_options(*open.scene, options.picture);
        ReportTexts texts;
        texts.result = inspect_scene(*open.scene, options, job);
        texts.json = report_json(texts.result.report);
        texts.html = report_html(texts.result.report);
        return texts;
    });
}

} // namespace

void add_inspections(py::module_& module) {
    module.def("check_json", &check, py::arg("input"), py::arg("preset"), py::arg("join"),
               py::arg("unit"), py::arg("axes"), py::arg("progress"), py::arg("threads"));
    py::class_<ReportTexts>(module, "ReportTexts")
        .def_readonly("json", &ReportTexts::json)
        .def_readonly("html", &ReportTexts::html)
        .def("files", [](const ReportTexts& texts, const std::filesystem::path& folder) {
            py::dict files;
            for (const auto& [name, content] : result_files(folder, texts.result))
                files[py::str(name)] = py::bytes(content);
            return files;
        });
    module.def("inspect_texts", &inspect, py::arg("scene"), py::arg("preset"), py::arg("join"),
               py::arg("views"), py::arg("rig"), py::arg("progress"), py::arg("threads"));
}

} // namespace keiko::python
