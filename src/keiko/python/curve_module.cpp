#include "keiko/api/lines.h"
#include "keiko/base/error.h"
#include "keiko/base/output_folder.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace keiko::python {
namespace {

using Spline = NurbsCurve<Vec4>;
using Color = std::optional<std::array<double, 3>>;

/// A B-spline of its knots and of n rows of x, y, z (mm) and weight.
Spline spline(int degree, const NumberRows& knots, const NumberRows& points) {
    if (knots.ndim() != 1) throw FieldError("knots", "an array of n numbers is needed");
    if (points.ndim() != 2 || points.shape(1) != 4)
        throw FieldError("points", "an array of n rows of 4 is needed: x, y, z in mm and weight");
    Spline made{degree, std::vector<double>(knots.data(), knots.data() + knots.size()), {}};
    const auto rows = points.unchecked<2>();
    for (py::ssize_t i = 0; i < points.shape(0); ++i) {
        const double weight = rows(i, 3);
        made.points.emplace_back(rows(i, 0) * weight, rows(i, 1) * weight, rows(i, 2) * weight,
                                 weight);
    }
    if (const std::string fault = fault_of(made); !fault.empty()) throw FieldError("Spline", fault);
    return made;
}

py::array_t<double> points_of(const Spline& spline) {
    py::array_t<double> array({static_cast<py::ssize_t>(spline.points.size()), py::ssize_t{4}});
    auto rows = array.mutable_unchecked<2>();
    for (std::size_t i = 0; i < spline.points.size(); ++i) {
        const Vec4& p = spline.points[i];
        const auto row = static_cast<py::ssize_t>(i);
        rows(row, 0) = p.x / p.w, rows(row, 1) = p.y / p.w, rows(row, 2) = p.z / p.w;
        rows(row, 3) = p.w;
    }
    return array;
}

py::array_t<double> knots_of(const Spline& spline) {
    return py::array_t<double>(static_cast<py::ssize_t>(spline.knots.size()), spline.knots.data());
}

NamedCurve curve(const std::string& name, std::vector<Spline> pieces, const Color& color,
                 double deviation) {
    if (pieces.empty()) throw FieldError("pieces", "a curve has at least one");
    if (!(deviation >= 0 && std::isfinite(deviation)))
        throw FieldError("deviation", "is not 0 mm or above");
    NamedCurve made{name, {}, deviation, std::move(pieces)};
    for (const double share : color.value_or(std::array<double, 3>{}))
        if (!(share >= 0 && share <= 1)) throw FieldError("color", "is not 0 to 1");
    if (color) made.color.emplace((*color)[0], (*color)[1], (*color)[2]);
    return made;
}

Color color_of(const NamedCurve& curve) {
    if (!curve.color) return std::nullopt;
    return Color({curve.color->r, curve.color->g, curve.color->b});
}

std::vector<NamedCurve> read(const std::filesystem::path& file, const py::object& progress,
                             int threads) {
    return run({progress, threads}, [&](const Job& job) { return read_curves(file, {}, job); })
        .curves;
}

void write(std::vector<NamedCurve> curves, const std::filesystem::path& file,
           const std::string& name, const py::object& progress, int threads) {
    const CurveSet set{name, std::move(curves)};
    const std::string bytes =
        run({progress, threads}, [&](const Job& job) { return curve_output(set, file, {}, job); });
    FileTransaction outputs;
    outputs.add(file, bytes);
    outputs.write();
}

void add_classes(py::module_& module) {
    py::class_<Spline>(module, "Spline", "A rational B-spline of any degree.")
        .def(py::init(&spline), py::arg("degree"), py::arg("knots"), py::arg("points"))
        .def_readonly("degree", &Spline::degree, "1 or more.")
        .def_property_readonly("knots", &knots_of, "Rising numbers, (n + degree + 1).")
        .def_property_readonly("points", &points_of,
                               "Control points: x, y, z in mm and weight, (n, 4).")
        .def("__reduce__", [](const py::object& self) {
            const auto& one = self.cast<const Spline&>();
            return py::make_tuple(self.attr("__class__"),
                                  py::make_tuple(one.degree, knots_of(one), points_of(one)));
        });
    py::class_<NamedCurve>(module, "Curve",
                           "A named curve in space, of one spline or several in turn.")
        .def(py::init(&curve), py::arg("name"), py::arg("pieces"), py::arg("color") = py::none(),
             py::arg("deviation") = 0.0)
        .def_readonly("name", &NamedCurve::name,
                      "That other programs show; of curves by Keiko it carries the verdict.")
        .def_property_readonly(
            "color", &color_of,
            "Red, green and blue in linear light, 0 to 1; None without a colour.")
        .def_readonly("deviation", &NamedCurve::deviation,
                      "How far it lies from the exact curve, mm: about this at most.")
        .def_readonly("pieces", &NamedCurve::pieces,
                      "Splines, the next from where the last one ends.")
        .def("__repr__", [](const NamedCurve& one) { return "<Curve: " + one.name + ">"; })
        .def("__reduce__", [](const py::object& self) {
            const auto& one = self.cast<const NamedCurve&>();
            return py::make_tuple(
                self.attr("__class__"),
                py::make_tuple(one.name, one.pieces, color_of(one), one.deviation));
        });
}

} // namespace

void add_curves(py::module_& module) {
    add_classes(module);
    module.def("read_curves", &read, py::arg("file"), py::kw_only(),
               py::arg("progress") = py::none(), py::arg("threads") = 0,
               "Reads the free curves of a STEP or IGES file, a Curve each.");
    module.def("write_curves", &write, py::arg("curves"), py::arg("file"), py::kw_only(),
               py::arg("name") = "", py::arg("progress") = py::none(), py::arg("threads") = 0,
               "Writes curves to a STEP or IGES file, or polylines of them to a .vtp "
               "file.\n\n`name` is that of the body they lie on.");
}

} // namespace keiko::python
