#include "keiko/api/model.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// The models of files as one body. `name` stands for the files in the model and in errors, if it
/// is given.
OpenModel load(const py::object& input, const std::string& name, const std::string& unit,
               const std::string& axes, const py::object& progress, int threads) try {
    const std::vector<std::filesystem::path> paths = paths_of(input);
    return run({progress, threads}, [&](const Job& job) {
        LoadOptions options;
        options.unit = unit, options.axes = axes;
        std::vector<SurfaceModel> models;
        for (const std::filesystem::path& path : paths)
            models.push_back(load_model(path, options, job));
        SurfaceModel body = models.size() == 1 ? std::move(models.front()) : merge(models);
        if (!name.empty()) body.source = name;
        return OpenModel{std::make_shared<const SurfaceModel>(std::move(body)),
                         name.empty() ? paths : std::vector<std::filesystem::path>{}};
    });
} catch (const Error& error) {
    if (name.empty()) throw;
    throw Error(name, error.where(), error.reason());
}

/// A model of its serialised bytes, as pickles hold them.
OpenModel unpickled(const py::bytes& bytes, const std::vector<std::filesystem::path>& paths) {
    return {std::make_shared<const SurfaceModel>(
                deserialize(static_cast<std::string_view>(bytes), "a pickled model")),
            paths};
}

py::array bounds_of(const OpenModel& open) {
    return corners_of(
        run({py::none(), 0}, [&](const Job& job) { return material_bounds(*open.model, job); }));
}

std::string words_of(const OpenModel& open) {
    const SurfaceModel& model = *open.model;
    return model.source + ": " + std::to_string(model.faces.size()) + " faces, " +
           std::to_string(model.patches.size()) + " patches";
}

} // namespace

py::array corners_of(const Box3& box) {
    py::array_t<double> array({2, 3});
    auto numbers = array.mutable_unchecked<2>();
    for (int k = 0; k < 3; ++k) numbers(0, k) = box.lower[k], numbers(1, k) = box.upper[k];
    return array;
}

py::list faces_of(const SurfaceModel& model) {
    py::list faces;
    for (const Face& face : model.faces)
        faces.append(py::make_tuple(face.id, face.name, face.layer));
    return faces;
}

std::vector<std::string> losses_of(const SurfaceModel& model) {
    std::vector<std::string> reasons;
    for (const LostFace& face : model.lost_faces) reasons.push_back(face.reason);
    return reasons;
}

std::shared_ptr<const SurfaceModel> model_of(const py::object& input) {
    if (py::isinstance<OpenModel>(input)) return input.cast<const OpenModel&>().model;
    if (!py::isinstance<OpenScene>(input)) return nullptr;
    const auto& scene = input.cast<const OpenScene&>().scene;
    return {scene, &scene->model};
}

void add_models(py::module_& module) {
    py::class_<OpenModel>(
        module, "Model",
        "A body that has been read. keiko.load makes it; it is pickled by its content.")
        .def_property_readonly(
            "faces", [](const OpenModel& open) { return faces_of(*open.model); },
            "Number in reports, name and layer of each face.")
        .def_property_readonly(
            "lost_faces", [](const OpenModel& open) { return losses_of(*open.model); },
            "Why faces of the file were lost, a text each.")
        .def_property_readonly(
            "source", [](const OpenModel& open) { return open.model->source; },
            "Name of the file, or the one that was given.")
        .def_property_readonly(
            "unit", [](const OpenModel& open) { return open.model->unit; },
            "Unit of the file, as it was found or given; coordinates are in mm.")
        .def_property_readonly("bounds", &bounds_of, "Lowest and highest corner in mm, (2, 3).")
        .def("__repr__", [](const OpenModel& open) { return "<Model of " + words_of(open) + ">"; })
        .def("__reduce__", [](const OpenModel& open) {
            return py::make_tuple(py::module_::import("keiko").attr("_unpickled"),
                                  py::make_tuple(py::bytes(serialize(*open.model)), open.paths));
        });
    module.def("load_model", &load);
    module.def("unpickled_model", &unpickled);
}

} // namespace keiko::python
