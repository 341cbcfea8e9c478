#include "keiko/api/accept.h"
#include "keiko/api/check.h"
#include "keiko/api/inspect.h"
#include "keiko/api/lines.h"
#include "keiko/api/place.h"
#include "keiko/api/results.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <map>
#include <optional>

namespace py = pybind11;

namespace keiko::python {
namespace {

std::vector<std::string> words_of(const py::dict& arguments, const char* name) {
    return taken<std::vector<std::string>>(arguments, name);
}

/// Sets what check and inspect judge alike, from their keyword arguments. Throws Error naming the
/// argument.
template <class Options>
void set_judging(const py::dict& judging, Options& options) {
    options.preset = preset_by_name_or_file(taken<std::string>(judging, "preset"));
    options.join = options.combs.join = require_join(taken<double>(judging, "join"));
    options.scope = scope_of(judging);
    for (const std::string& plane : words_of(judging, "sections"))
        options.combs.planes.push_back(section_plane(plane));
    options.combs.iso_curves = taken<int>(judging, "iso_curves");
    options.joints = taken<bool>(judging, "joints");
    const auto accepted = taken<std::optional<std::filesystem::path>>(judging, "accepted");
    if (accepted) options.acceptances = read_acceptances(*accepted, date_today());
}

/// The documents and curves of a check, all but the first if they were requested.
struct CheckDocuments {
    std::string inspection;
    std::optional<std::string> combs, profiles;
    std::vector<NamedCurve> curves;

    CheckDocuments(const CheckResult& result, const CheckOptions& options, bool with_curves)
        : inspection(inspection_json(result.inspection, version())) {
        if (result.combs) combs = result.combs->json;
        if (options.profiles)
            profiles = profiles_json(result.profiles, result.inspection, version());
        if (with_curves) curves = check_curves(result, options).curves;
    }
};

/// The documents of a check: the inspection, its combs and its profiles, None where none were
/// requested, and its curves.
py::tuple check(const py::object& input, const py::dict& judging, const std::string& unit,
                const std::string& axes, bool profiles, bool curves, const py::object& progress,
                int threads) {
    const std::shared_ptr<const SurfaceModel> model = model_of(input);
    const auto paths = model ? std::vector<std::filesystem::path>() : paths_of(input);
    if (model) require_no_reading(unit, axes);
    CheckOptions options;
    set_judging(judging, options);
    options.load.unit = unit, options.load.axes = axes, options.profiles = profiles;
    CheckDocuments found = run({progress, threads}, [&](const Job& job) {
        return CheckDocuments(
            model ? check_body(*model, options, job) : check_models(paths, options, job), options,
            curves);
    });
    return py::make_tuple(found.inspection, found.combs, found.profiles, found.curves);
}

/// The files of the preset and the acceptances, for the inputs of a report.
std::vector<std::filesystem::path> settings_of(const py::dict& judging) {
    std::vector<std::filesystem::path> files;
    const auto preset = taken<std::string>(judging, "preset");
    if (is_preset_path(preset)) files.emplace_back(preset);
    const auto accepted = taken<std::optional<std::filesystem::path>>(judging, "accepted");
    if (accepted) files.push_back(*accepted);
    return files;
}

/// The files of a report, by name.
py::dict inspect(const OpenScene& open, const py::dict& judging,
                 const std::vector<std::string>& views, const py::object& rig,
                 std::size_t close_ups, const py::object& progress, int threads) {
    InspectOptions options;
    set_judging(judging, options);
    options.settings = settings_of(judging);
    options.views = views, options.close_ups = close_ups;
    const ChosenRig lamps(rig);
    return bytes_of(run({progress, threads}, [&](const Job& job) {
        return under(lamps, *open.scene, [&](const Scene& scene, const auto& file) {
            options.rig = file;
            options.picture = picture_options(scene, options.picture);
            return result_files(".", inspect_scene(scene, options, job));
        });
    }));
}

/// Writes the files of a report as `keiko inspect` does: earlier results in the folder are
/// withdrawn, its own that were changed excepted, and it gets its list of files. `base`: folder
/// that the files which the report names are relative to.
void write(const std::filesystem::path& folder, const std::map<std::string, py::bytes>& files,
           const std::filesystem::path& base) {
    FolderContent content;
    for (const auto& [name, bytes] : files) content[name] = bytes;
    if (const auto rig = content.find("rig.toml"); rig != content.end())
        rig->second = rig_text(parse_rig(rig->second, base / "rig.toml"), folder);
    withdraw_results({{}, {folder}}, {});
    FileTransaction outputs;
    outputs.add_folder(folder, with_manifest(std::move(content)));
    outputs.write();
}

/// Adds findings of a report to a file of accepted ones, and returns how many it holds then.
std::size_t accept(const std::filesystem::path& report, const std::vector<std::size_t>& items,
                   const std::filesystem::path& output, const std::vector<std::size_t>& findings,
                   const std::string& why, const std::string& who, const std::string& until) {
    const AcceptanceList earlier = earlier_acceptances(output, date_today());
    const AcceptanceNote note{who, why, earlier.today, until};
    const AddedAcceptances all = accept_items(earlier, output, report, {items, findings}, note);
    FileTransaction outputs;
    outputs.add(output, acceptances_json(all.entries));
    outputs.write();
    return all.entries.size();
}

} // namespace

py::dict bytes_of(const FolderContent& content) {
    py::dict files;
    for (const auto& [name, bytes] : content) files[py::str(name)] = py::bytes(bytes);
    return files;
}

double require_join(double join) {
    if (!(join >= 1e-6 && join <= 1000)) throw FieldError("join", "is not 1e-6 to 1000 mm");
    return join;
}

Scope scope_of(const py::dict& arguments) {
    Scope scope;
    scope.selection.faces = words_of(arguments, "faces");
    scope.selection.layers = words_of(arguments, "layers");
    scope.zones = words_of(arguments, "zones");
    for (const std::string& color : words_of(arguments, "colors"))
        scope.selection.colors.push_back(FaceColor::parse(color));
    return scope;
}

void add_inspections(py::module_& module) {
    module.def("check_json", &check);
    module.def("report_files", &inspect);
    module.def("write_report", &write);
    module.def("accept_findings", &accept, py::arg("report"), py::arg("items"), py::arg("output"),
               py::kw_only(), py::arg("findings"), py::arg("why"), py::arg("who"),
               py::arg("until") = "");
}

} // namespace keiko::python
