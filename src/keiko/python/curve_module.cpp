#include "keiko/api/lines.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// A B-spline curve in arrays of its own.
struct Spline {
    int degree = 0;
    py::array_t<double> knots, points; ///< points: n rows of x, y, z and weight, mm
};

Spline spline_of(const NurbsCurve<Vec4>& curve) {
    Spline spline{
        curve.degree,
        py::array_t<double>(static_cast<py::ssize_t>(curve.knots.size()), curve.knots.data()),
        py::array_t<double>({static_cast<py::ssize_t>(curve.points.size()), py::ssize_t{4}})};
    auto rows = spline.points.mutable_unchecked<2>();
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const Vec4& p = curve.points[i];
        const auto row = static_cast<py::ssize_t>(i);
        rows(row, 0) = p.x / p.w, rows(row, 1) = p.y / p.w, rows(row, 2) = p.z / p.w;
        rows(row, 3) = p.w;
    }
    return spline;
}

/// A curve with its pieces.
struct Curve {
    std::string name;
    std::optional<std::array<double, 3>> color;
    std::vector<Spline> pieces;
};

std::vector<Curve> read(const std::filesystem::path& file, const py::object& progress,
                        int threads) {
    const CurveSet set =
        run({progress, threads}, [&](const Job& job) { return read_curves(file, {}, job); });
    std::vector<Curve> curves;
    for (const NamedCurve& one : set.curves) {
        Curve& curve = curves.emplace_back(Curve{one.name, {}, {}});
        if (one.color) curve.color = {one.color->r, one.color->g, one.color->b};
        for (const NurbsCurve<Vec4>& piece : one.pieces) curve.pieces.push_back(spline_of(piece));
    }
    return curves;
}

} // namespace

void add_curves(py::module_& module) {
    py::class_<Spline>(module, "Spline")
        .def_readonly("degree", &Spline::degree)
        .def_readonly("knots", &Spline::knots)
        .def_readonly("points", &Spline::points);
    py::class_<Curve>(module, "Curve")
        .def_readonly("name", &Curve::name)
        .def_readonly("color", &Curve::color)
        .def_readonly("pieces", &Curve::pieces);
    module.def("read_curves", &read, py::arg("file"), py::kw_only(),
               py::arg("progress") = py::none(), py::arg("threads") = 0);
}

} // namespace keiko::python
