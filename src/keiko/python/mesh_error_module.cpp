#include "keiko/api/compare.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <string>
#include <vector>

namespace py = pybind11;

namespace keiko::python {
namespace {

MeshErrorOptions options_of(const std::vector<double>& deviations, const py::dict& given) {
    MeshErrorOptions options;
    options.deviations = deviations;
    options.views = taken<std::vector<std::string>>(given, "views");
    options.mesher = mesher_by_name(taken<std::string>(given, "mesher"));
    options.normals = corner_normals_by_name(taken<std::string>(given, "normals"));
    return options;
}

/// The scene with pictures of a size; `width` 0: its own.
Scene sized(Scene scene, int width, int height) {
    if ((width != 0) != (height != 0))
        throw FieldError("width", "and height are both above 0, or both 0");
    if (width == 0) return scene;
    require_size("width", width), require_size("height", height);
    scene.set_picture_size(width, height);
    return scene;
}

/// The files of a comparison of meshes with the surface, by name.
py::dict mesh_error(const OpenScene& open, const std::vector<double>& deviations,
                    const py::object& rig, const py::dict& given, const py::object& progress,
                    int threads) {
    MeshErrorOptions options = options_of(deviations, given);
    const ChosenRig lamps(rig);
    const Scene shown = sized(*open.scene, taken<int>(given, "width"), taken<int>(given, "height"));
    return bytes_of(run({progress, threads}, [&](const Job& job) {
        return under(lamps, shown, [&](const Scene& scene, const auto& file) {
            options.rig = file;
            return mesh_error_files(keiko::mesh_error(scene, options, job));
        });
    }));
}

} // namespace

void add_mesh_errors(py::module_& module) {
    module.def("mesh_error_files", &mesh_error);
}

} // namespace keiko::python
