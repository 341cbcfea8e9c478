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

py::dict bytes_of(const FolderContent& content) {
    py::dict files;
    for (const auto& [name, bytes] : content) files[py::str(name)] = py::bytes(bytes);
    return files;
}

/// The files of a report, by name.
py::dict inspect(const OpenScene& open, const std::string& preset, double join,
                 const std::vector<std::string>& views,
                 const std::optional<std::filesystem::path>& rig, const py::object& progress,
                 int threads) {
    return bytes_of(run({progress, threads}, [&](const Job& job) {
        InspectOptions options;
        options.preset = preset_by_name_or_file(preset), options.join = join;
        options.views = views, options.rig = rig;
        options.picture = picture_options(*open.scene, options.picture);
        return result_files(".", inspect_scene(*open.scene, options, job));
    }));
}

} // namespace

void add_inspections(py::module_& module) {
    module.def("check_json", &check);
    module.def("report_files", &inspect);
}

} // namespace keiko::python
