#include "keiko/api/place.h"
#include "keiko/api/render.h"
#include "keiko/api/view.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <utility>
#include <vector>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// An image that NumPy sees without a copy, H x W x channels.
py::array array_of(const Image& image, const py::object& owner) {
    return py::array_t<float>({image.height, image.width, image.channels}, image.values.data(),
                              owner);
}

/// Records of a buffer as NumPy sees them, without a copy.
template <class Record>
py::array records_of(const std::vector<Record>& records, std::vector<py::ssize_t> shape,
                     const py::object& owner) {
    return py::array_t<Record>(std::move(shape), records.data(), owner);
}

NamedView view_named(const Scene& scene, const std::string& view, std::optional<int> width,
                     std::optional<int> height, const Job& job) {
    const std::vector<std::string> names(view.empty() ? 0 : 1, view);
    return choose_views(scene, names, 1, width.value_or(scene.width), height.value_or(scene.height),
                        job)
        .front();
}

DeepBuffer deep(const OpenScene& open, const std::string& view, std::optional<int> width,
                std::optional<int> height, int reflections, const py::object& progress,
                int threads) {
    return run({progress, threads}, [&](const Job& job) {
        const NamedView seen = view_named(*open.scene, view, width, height, job);
        return deep_view(*open.scene, seen.camera, {.rows = {}, .reflections = reflections}, job);
    });
}

Film render(const OpenScene& open, const std::string& view, const py::object& rig,
            std::optional<int> width, std::optional<int> height,
            const std::vector<std::string>& aovs, const py::object& progress, int threads) {
    const ChosenRig chosen(rig);
    return run({progress, threads}, [&](const Job& job) {
        const Scene& scene = *open.scene;
        const NamedView seen = view_named(scene, view, width, height, job);
        PictureOptions options;
        for (const std::string& name : aovs) options.aovs.push_back(aov_by_name(name));
        const LightRig lamps =
            chosen.rig ? *chosen.rig
                       : choose_lights(scene, chosen.file, std::span(&seen, 1), {}, job).rig;
        return render_view(scene, lamps, seen.camera, picture_options(scene, options), job);
    });
}

} // namespace

void add_pictures(py::module_& module) {
    const auto color = [](const py::object& film, const py::args&, const py::kwargs&) {
        return array_of(film.cast<const Film&>().color, film);
    };
    py::class_<Film>(module, "Film")
        .def_property_readonly("color", color)
        .def_property_readonly(
            "alpha",
            [](const py::object& film) { return array_of(film.cast<const Film&>().alpha, film); })
        .def_property_readonly("aovs",
                               [](const py::object& film) {
                                   py::dict layers;
                                   for (const auto& [aov, image] : film.cast<const Film&>().aovs)
                                       layers[py::str(std::string(name_of(aov)))] =
                                           array_of(image, film);
                                   return layers;
                               })
        .def("__array__", color)
        .def("_repr_png_",
             [](const Film& film) { return py::bytes(encode_png(tone_mapped(film))); });
    module.def("render_film", &render);
    PYBIND11_NUMPY_DTYPE(DeepSample, t, normal_x, normal_y, shape_xx, shape_xy, shape_yy, way,
                         face);
    PYBIND11_NUMPY_DTYPE(DeepBounce, pixel, sample);
    py::class_<DeepBuffer>(module, "DeepBuffer")
        .def_property_readonly(
            "samples",
            [](const py::object& buffer) {
                const auto& deep = buffer.cast<const DeepBuffer&>();
                return records_of(deep.samples, {deep.height, deep.width}, buffer);
            })
        .def_property_readonly("bounces", [](const py::object& buffer) {
            const auto& deep = buffer.cast<const DeepBuffer&>();
            return records_of(deep.bounces, {static_cast<py::ssize_t>(deep.bounces.size())},
                              buffer);
        });
    module.def("deep_buffer", &deep);
}

} // namespace keiko::python
