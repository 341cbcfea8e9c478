#include "keiko/api/compare.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

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
    /// Opens the scene of the body, with pictures of the size of the views.
    OpenBody opener(const std::optional<CompareViewsOptions>& views) const {
        return [this, &views](const Job& job) {
            Scene scene =
                model ? scene_of_model(*model, {}, job) : open_scene(std::span(&file, 1), {}, job);
            if (views && views->width > 0) scene.set_picture_size(views->width, views->height);
            return scene;
        };
    }
};

/// The views of a comparison; nullopt for geometry alone.
std::optional<CompareViewsOptions> views_of(const py::dict& given) {
    const auto views = given["views"].cast<std::optional<std::vector<std::string>>>();
    const auto rig = given["rig"].cast<std::optional<std::filesystem::path>>();
    if (!views && rig) throw FieldError("rig", "needs views");
    if (!views) return std::nullopt;
    CompareViewsOptions options;
    options.views = *views, options.rig = rig;
    options.width = given["width"].cast<int>(), options.height = given["height"].cast<int>();
    if (options.width < 0 || options.height < 0 || (options.width > 0) != (options.height > 0))
        throw FieldError("width", "and height are both above 0, or both 0");
    return options;
}

/// The files of a comparison, by name.
py::dict compare(const py::object& before, const py::object& after, const py::dict& given,
                 const py::object& progress, int threads) {
    const ComparedBody former(before), latter(after);
    CompareBodiesOptions options;
    options.preset = preset_by_name_or_file(given["preset"].cast<std::string>());
    options.join = given["join"].cast<double>(), options.align = given["align"].cast<bool>();
    options.scope = scope_of(given), options.views = views_of(given);
    return bytes_of(run({progress, threads}, [&](const Job& job) {
        return comparison_files(".", compare_bodies(former.opener(options.views),
                                                    latter.opener(options.views), options, job));
    }));
}

} // namespace

void add_comparisons(py::module_& module) {
    module.def("comparison_files", &compare);
}

} // namespace keiko::python
