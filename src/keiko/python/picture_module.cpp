#include "keiko/api/place.h"
#include "keiko/api/render.h"
#include "keiko/api/view.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/solution.h"
#include "keiko/python/work.h"

#include <pybind11/numpy.h>

#include <cmath>
#include <map>
#include <memory>
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

DeepBuffer deep(const OpenScene& open, const std::string& view, std::optional<int> width,
                std::optional<int> height, int reflections, const py::object& progress,
                int threads) {
    return run({progress, threads}, [&](const Job& job) {
        const NamedView seen = view_named(*open.scene, view, width, height, job);
        return deep_view(*open.scene, seen.camera, {.rows = {}, .reflections = reflections}, job);
    });
}

/// The value of a word. Throws FieldError naming the argument for another word.
template <class Value>
Value value_of(const char* argument, const std::string& word,
               const std::map<std::string, Value>& values) {
    if (const auto found = values.find(word); found != values.end()) return found->second;
    std::string words;
    for (const auto& [name, value] : values) words += (words.empty() ? "" : ", ") + name;
    throw FieldError(argument, "'" + word + "' is none of " + words);
}

/// How light and edges are computed, from keyword arguments.
PictureOptions accuracy_of(const py::dict& given) {
    PictureOptions options;
    options.tubes = value_of<TubeModel>("penumbrae", taken<std::string>(given, "penumbrae"),
                                        {{"width", TubeModel::picture},
                                         {"exact", TubeModel::automatic},
                                         {"axis", TubeModel::preview}});
    options.light_error = taken<double>(given, "light_error");
    if (!(options.light_error >= 0 && options.light_error <= 0.1))
        throw FieldError("light_error", "is not 0 to 0.1");
    options.edge_samples = taken<int>(given, "edge_samples");
    if (options.edge_samples < 1 || options.edge_samples > 16)
        throw FieldError("edge_samples", "is not 1 to 16");
    options.gather_rays = taken<int>(given, "gather");
    constexpr int most = 65536;
    if (options.gather_rays < 0 || options.gather_rays > most)
        throw FieldError("gather", "is not 0 to " + std::to_string(most) + " rays");
    return options;
}

Film render(const OpenScene& open, const std::string& view, const py::object& rig,
            const py::object& solution, std::optional<int> width, std::optional<int> height,
            const std::vector<std::string>& aovs, const py::dict& accuracy,
            const py::object& progress, int threads) {
    const ChosenRig chosen(rig);
    const ChosenSolution light(solution);
    PictureOptions options = accuracy_of(accuracy);
    if (options.gather_rays > 0 && solution.is_none())
        throw FieldError("gather", "is of the light of a solution");
    for (const std::string& name : aovs) options.aovs.push_back(aov_by_name(name));
    return run({progress, threads}, [&](const Job& job) {
        const NamedView seen = view_named(*open.scene, view, width, height, job);
        const LightRig lamps = lamps_of(*open.scene, chosen, seen, job);
        const std::shared_ptr<const Scene> scene = light.lit(open, lamps);
        return render_view(*scene, lamps, seen.camera, picture_options(*scene, options), job);
    });
}

py::bytes png(const Film& film, const std::string& tone, const std::optional<double>& ev) {
    using Curve = ToneMapping::Curve;
    if (ev && !std::isfinite(*ev)) throw FieldError("ev", "is not a finite number");
    ToneMapping mapping;
    mapping.curve = value_of<Curve>(
        "tone", tone,
        {{"linear", Curve::linear}, {"log", Curve::logarithmic}, {"reinhard", Curve::reinhard}});
    mapping.ev = ev;
    return encode_png(tone_mapped(film, mapping));
}

/// A keiko.Picture.
py::object false_colors(const Film& film, double minimum, double maximum,
                        const std::string& quantity, bool iso_lines) {
    if (!(minimum > 0 && minimum < maximum && std::isfinite(maximum)))
        throw FieldError("minimum", "is not above 0 and below maximum");
    const auto shown = value_of<ShownQuantity>(
        "quantity", quantity,
        {{"luminance", ShownQuantity::luminance}, {"illuminance", ShownQuantity::illuminance}});
    const Image picture = false_color_picture(film, {minimum, maximum}, iso_lines, shown);
    return py::module_::import("keiko").attr("Picture")(py::bytes(encode_png(picture)));
}

} // namespace

void require_size(const std::string& name, std::optional<int> pixels) {
    constexpr int most = 65536; // as in scenes
    if (pixels && !(*pixels >= 1 && *pixels <= most))
        throw FieldError(name, "is not 1 to " + std::to_string(most) + " pixels");
}

NamedView view_named(const Scene& scene, const std::string& view, std::optional<int> width,
                     std::optional<int> height, const Job& job) {
    require_size("width", width);
    require_size("height", height);
    const std::vector<std::string> names(view.empty() ? 0 : 1, view);
    return choose_views(scene, names, 1, width.value_or(scene.width), height.value_or(scene.height),
                        job)
        .front();
}

LightRig lamps_of(const Scene& scene, const ChosenRig& chosen, const NamedView& view,
                  const Job& job) {
    if (chosen.rig) return *chosen.rig;
    return choose_lights(scene, chosen.file, std::span(&view, 1), {}, job).rig;
}

void add_pictures(py::module_& module) {
    const auto color = [](const py::object& film, const py::args&, const py::kwargs&) {
        return array_of(film.cast<const Film&>().color, film);
    };
    py::class_<Film>(module, "Film",
                     "The picture of a scene in linear light. numpy.asarray of it is its colour; a "
                     "notebook shows it.")
        .def_property_readonly("color", color, "Red, green and blue in cd/m2, (height, width, 3).")
        .def_property_readonly(
            "alpha",
            [](const py::object& film) { return array_of(film.cast<const Film&>().alpha, film); },
            "Share of each pixel that the body covers, 0 to 1, (height, width, 1).")
        .def_property_readonly(
            "aovs",
            [](const py::object& film) {
                py::dict layers;
                for (const auto& [aov, image] : film.cast<const Film&>().aovs)
                    layers[py::str(std::string(name_of(aov)))] = array_of(image, film);
                return layers;
            },
            "Requested layers by name, (height, width, channels), in the units of keiko render "
            "--aov.")
        .def("__array__", color)
        .def("_repr_png_",
             [](const Film& film) { return py::bytes(encode_png(tone_mapped(film))); })
        .def("png", &png, py::arg("tone") = "linear", py::arg("ev") = py::none(),
             "Bytes of a PNG file. `tone` is linear, log or reinhard; `ev` the exposure, None for "
             "that of the picture.")
        .def(
            "exr", [](const Film& film) { return py::bytes(encode_exr(film)); },
            "Bytes of an OpenEXR file with colour, alpha and layers.")
        .def("false_colors", &false_colors, py::arg("minimum") = FalseColorScale{}.minimum,
             py::arg("maximum") = FalseColorScale{}.maximum, py::arg("quantity") = "luminance",
             py::arg("iso_lines") = false,
             "The picture of a quantity, luminance in cd/m2 or illuminance in lx, over a range, "
             "with a legend.\n\nIlluminance needs the layer `illuminance`. Raises Error for a "
             "range that does not rise from above 0.");
    module.def("render_film", &render);
    PYBIND11_NUMPY_DTYPE(DeepSample, t, normal_x, normal_y, shape_xx, shape_xy, shape_yy, way,
                         face);
    PYBIND11_NUMPY_DTYPE(DeepBounce, pixel, sample);
    py::class_<DeepBuffer>(
        module, "DeepBuffer",
        "The surfaces on the paths of a picture's rays, as keiko-deep/1 has them.")
        .def_property_readonly(
            "samples",
            [](const py::object& buffer) {
                const auto& deep = buffer.cast<const DeepBuffer&>();
                return records_of(deep.samples, {deep.height, deep.width}, buffer);
            },
            "The surface that each pixel shows, (height, width), with the numbers of keiko-deep/1.")
        .def_property_readonly(
            "bounces",
            [](const py::object& buffer) {
                const auto& deep = buffer.cast<const DeepBuffer&>();
                return records_of(deep.bounces, {static_cast<py::ssize_t>(deep.bounces.size())},
                                  buffer);
            },
            "Surfaces that mirrors show, each with its pixel.");
    module.def("deep_buffer", &deep);
}

} // namespace keiko::python
