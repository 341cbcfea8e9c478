#include "keiko/api/compare.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <span>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// A body to compare: one that has been read, or the file of one.
struct ComparedBody {
    std::shared_ptr<const SurfaceModel> model;
    std::filesystem::path file;

    explicit ComparedBody(const py::object& input) : model(model_of(input)) {
        if (!model) file = path_of(input);
    }
    /// Opens the scene of the body, with pictures of the size of the views and the lamps at hand.
    OpenBody opener(const std::optional<CompareViewsOptions>& views, const ChosenRig& lamps) const {
        return [this, &views, &lamps](const Job& job) {
            Scene scene =
                model ? scene_of_model(*model, {}, job) : open_scene(std::span(&file, 1), {}, job);
            if (views && views->width > 0) scene.set_picture_size(views->width, views->height);
            if (lamps.rig) scene.rig = lamps.rig;
            return scene;
        };
    }
};

/// The views of a comparison; nullopt for geometry alone.
std::optional<CompareViewsOptions> views_of(const py::dict& given, const ChosenRig& lamps) {
    const auto views = taken<std::optional<std::vector<std::string>>>(given, "views");
    if (!views && (lamps.file || lamps.rig)) throw FieldError("rig", "needs views");
    if (!views) return std::nullopt;
    CompareViewsOptions options;
    options.views = *views, options.rig = lamps.file;
    options.width = taken<int>(given, "width"), options.height = taken<int>(given, "height");
    if (options.width < 0 || options.height < 0 || (options.width > 0) != (options.height > 0))
        throw FieldError("width", "and height are both above 0, or both 0");
    if (options.width > 0)
        require_size("width", options.width), require_size("height", options.height);
    return options;
}

/// The files of a comparison, by name.
py::dict compare(const py::object& before, const py::object& after, const py::dict& given,
                 const py::object& progress, int threads) {
    const ComparedBody former(before), latter(after);
    const ChosenRig lamps(given["rig"]);
    CompareBodiesOptions options;
    options.preset = preset_by_name_or_file(taken<std::string>(given, "preset"));
    options.join = require_join(taken<double>(given, "join"));
    options.align = taken<bool>(given, "align");
    options.scope = scope_of(given), options.views = views_of(given, lamps);
    return bytes_of(run({progress, threads}, [&](const Job& job) {
        return comparison_files(".",
                                compare_bodies(former.opener(options.views, lamps),
                                               latter.opener(options.views, lamps), options, job));
    }));
}

} // namespace

void add_comparisons(py::module_& module) {
    module.def("comparison_files", &compare);
}

} // namespace keiko::python
