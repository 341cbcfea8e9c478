#include "keiko/api/trace.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <span>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// A row of the array of hits.
struct HitRow {
    double t;
    std::uint32_t face, instance, patch, flags;
    double uv[2], position[3], normal[3];
    double k1, k2, bound;
};

void put(const Vec3& from, double (&to)[3]) {
    to[0] = from.x, to[1] = from.y, to[2] = from.z;
}

HitRow row_of_nothing() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    HitRow row{};
    row.t = std::numeric_limits<double>::infinity();
    put(Vec3(none), row.position), put(Vec3(none), row.normal);
    row.uv[0] = row.uv[1] = row.k1 = row.k2 = row.bound = none;
    return row;
}

HitRow row_of(const Hit& hit) {
    HitRow row = row_of_nothing();
    row.t = hit.t, row.face = hit.face;
    row.instance = hit.instance, row.patch = hit.patch;
    row.flags = static_cast<std::uint32_t>(hit.flags);
    row.uv[0] = hit.uv.x, row.uv[1] = hit.uv.y;
    put(hit.position, row.position), put(hit.normal, row.normal);
    const PrincipalCurvatures bent = curvatures_of(hit);
    row.k1 = bent.k1, row.k2 = bent.k2;
    row.bound = hit.position_bound;
    return row;
}

/// The array takes over the rows.
py::array array_of(std::vector<HitRow> rows) {
    auto owned = std::make_unique<std::vector<HitRow>>(std::move(rows));
    const HitRow* data = owned->data();
    const auto count = static_cast<py::ssize_t>(owned->size());
    const py::capsule owner(owned.release(),
                            [](void* p) { delete static_cast<std::vector<HitRow>*>(p); });
    return py::array_t<HitRow>(count, data, owner);
}

/// Rays of anything that NumPy can make rows of numbers of. Raises keiko.Error for anything else.
std::vector<Ray> rays_from(const py::object& given) {
    constexpr const char *field = "rays", *meaning = "origin and direction";
    const py::object rows = py::module_::import("keiko._arguments").attr("rows");
    return rays_of(rows(field, given, 6, meaning).cast<NumberRows>(), field, meaning);
}

py::array trace(const OpenScene& open, const py::object& array, const py::object& progress,
                int threads) {
    const std::vector<Ray> rays = rays_from(array);
    return array_of(run({progress, threads}, [&](const Job& job) {
        std::vector<HitRow> rows(rays.size());
        trace_hits(
            *open.scene, rays,
            [&](std::size_t i, const Hit* hit) { rows[i] = hit ? row_of(*hit) : row_of_nothing(); },
            job);
        return rows;
    }));
}

/// The index of the ray of each hit, and the hits of all rays, by ray and rising t.
py::tuple trace_all(const OpenScene& open, const py::object& array, const py::object& progress,
                    int threads) {
    const std::vector<Ray> rays = rays_from(array);
    const auto found = run({progress, threads}, [&](const Job& job) {
        std::vector<std::vector<HitRow>> rows(rays.size());
        trace_all_hits(
            *open.scene, rays,
            [&](std::size_t i, std::span<const Hit> hits) {
                std::transform(hits.begin(), hits.end(), std::back_inserter(rows[i]), row_of);
            },
            job);
        return rows;
    });
    std::vector<std::int64_t> numbers;
    std::vector<HitRow> hits;
    for (std::size_t i = 0; i < found.size(); ++i) {
        numbers.insert(numbers.end(), found[i].size(), static_cast<std::int64_t>(i));
        hits.insert(hits.end(), found[i].begin(), found[i].end());
    }
    const py::array ray =
        py::array_t<std::int64_t>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
    return py::make_tuple(ray, array_of(std::move(hits)));
}

/// n rows of red, green and blue, cd/m2.
py::array luminance(const OpenScene& open, const NumberRows& array, const py::object& rig,
                    const py::object& progress, int threads) {
    const std::vector<Ray> rays = rays_of(array, "rays", "origin and direction");
    const ChosenRig lamps(rig);
    const std::vector<Rgb> found = run({progress, threads}, [&](const Job& job) {
        return luminances_along(*open.scene, lamps.of(*open.scene), rays, job);
    });
    py::array_t<double> colors({static_cast<py::ssize_t>(found.size()), py::ssize_t{3}});
    auto rows = colors.mutable_unchecked<2>();
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto row = static_cast<py::ssize_t>(i);
        rows(row, 0) = found[i].r, rows(row, 1) = found[i].g, rows(row, 2) = found[i].b;
    }
    return colors;
}

OpenScene open(const py::object& input, const std::string& unit, const std::string& axes,
               const std::string& material, bool shadows, double frame, const py::object& progress,
               int threads) {
    SceneOptions options;
    options.load.unit = unit, options.load.axes = axes;
    options.material = material, options.shadows = shadows, options.frame = frame;
    OpenScene opened{{}, nullptr, unit, axes, material, shadows, frame, nullptr};
    if (py::isinstance<OpenModel>(input)) {
        const auto& [model, paths] = input.cast<const OpenModel&>();
        require_no_reading(unit, axes);
        opened.paths = paths, opened.model = model;
    } else {
        opened.paths = paths_of(input);
    }
    opened.scene = run({progress, threads}, [&](const Job& job) {
        if (!opened.model)
            return std::make_shared<const Scene>(open_scene(opened.paths, options, job));
        Scene scene = scene_of_model(*opened.model, options, job);
        scene.inputs = opened.paths;
        return std::make_shared<const Scene>(std::move(scene));
    });
    return opened;
}

} // namespace

void add_scenes(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(HitRow, t, face, instance, patch, flags, uv, position, normal, k1, k2,
                         bound);
    module.attr("hit_dtype") = py::dtype::of<HitRow>();
    py::class_<OpenScene>(module, "Scene",
                          "A body or a scene file, ready for rays. keiko.open_scene makes it; it "
                          "is pickled by its paths, or by its Model.")
        .def("trace", &trace, py::arg("rays"), py::kw_only(), py::arg("progress") = py::none(),
             py::arg("threads") = 0,
             "The first hit of rays (n, 6), origin in mm and direction: n rows of hit_dtype.\n\nA "
             "row of a ray that meets nothing has an infinite t and the face 0. Raises Error for "
             "another shape, numbers that are not finite and directions of length 0.")
        .def("trace_all", &trace_all, py::arg("rays"), py::kw_only(),
             py::arg("progress") = py::none(), py::arg("threads") = 0,
             "All hits of rays (n, 6): the index of the ray of each hit, and rows of hit_dtype, by "
             "ray and rising t.\n\nRaises Error as trace does.")
        .def_property_readonly(
            "faces", [](const OpenScene& open) { return faces_of(open.scene->model); },
            "Number in reports, name and layer of each face.")
        .def_property_readonly(
            "bounds", [](const OpenScene& open) { return corners_of(open.scene->tracer.bounds()); },
            "Lowest and highest corner in mm, (2, 3).")
        .def_property_readonly(
            "lost_faces", [](const OpenScene& open) { return losses_of(open.scene->model); },
            "Why faces of the files were lost, a text each.")
        .def_readonly("paths", &OpenScene::paths,
                      "Files that it was read from; none if its Model was read from bytes.")
        .def("__reduce__", [](const OpenScene& open) {
            const py::dict options(py::arg("unit") = open.unit, py::arg("axes") = open.axes,
                                   py::arg("material") = open.material,
                                   py::arg("shadows") = open.shadows,
                                   py::arg("frame") = open.frame);
            return py::make_tuple(
                py::module_::import("keiko").attr("_reopen"),
                py::make_tuple(
                    open.model ? py::cast(OpenModel{open.model, open.paths}) : py::cast(open.paths),
                    options));
        });
    module.def("luminance_numbers", &luminance);
    module.def(
        "open_scene", &open, py::arg("input"), py::kw_only(), py::arg("unit") = "",
        py::arg("axes") = "", py::arg("material") = SceneOptions{}.material,
        py::arg("shadows") = false, py::arg("frame") = 0.0, py::arg("progress") = py::none(),
        py::arg("threads") = 0,
        "Opens a scene file, or makes the scene of model files or of a Model.\n\n`unit` and `axes` "
        "are those of keiko check, `material` the name of one built in or a file, `frame` the time "
        "in a scene's animation. With `shadows` the body hides lamps from itself.");
}

} // namespace keiko::python
