#include "keiko/api/check.h"
#include "keiko/api/inspect.h"
#include "keiko/api/place.h"
#include "keiko/api/results.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <map>

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

/// Writes the files of a report as `keiko inspect` does: earlier results in the folder are
/// withdrawn, and the rig names its luminaires from there. `base`: the folder from which it does.
void write_report(const std::filesystem::path& folder,
                  const std::map<std::string, std::string>& files,
                  const std::filesystem::path& base) {
    FolderContent content(files.begin(), files.end());
    if (const auto rig = content.find("rig.toml"); rig != content.end())
        rig->second = rig_text(parse_rig(rig->second, (base / rig->first).string()), folder);
    withdraw_results({.files = {}, .folders = {folder}}, {});
    FileTransaction outputs;
    outputs.add_folder(folder, with_manifest(std::move(content)));
    outputs.write();
}

} // namespace

void add_inspections(py::module_& module) {
    module.def("check_json", &check);
    module.def("report_files", &inspect);
    module.def("write_report", &write_report);
}

} // namespace keiko::python
