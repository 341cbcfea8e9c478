#include "keiko/api/compare.h"
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

/// A row of the array of deviations.
struct DeviationRow {
    double distance;
    double closest[3];
    std::uint32_t face;
    bool beside, certain;
};

std::vector<Vec3> points_of(const NumberRows& array) {
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw FieldError("scan", "an array of n rows of 3 is needed: x, y and z in mm");
    const auto numbers = array.unchecked<2>();
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(array.shape(0)));
    for (py::ssize_t i = 0; i < array.shape(0); ++i)
        points.emplace_back(numbers(i, 0), numbers(i, 1), numbers(i, 2));
    return points;
}

/// Rows with the numbers that reports give faces; 0 where nothing is within reach.
py::array rows_of(const Scene& scene, const std::vector<PointDeviation>& points) {
    py::array_t<DeviationRow> array(static_cast<py::ssize_t>(points.size()));
    DeviationRow* row = array.mutable_data();
    const std::vector<PlacedFace> faces = placed_faces(scene.model);
    for (const PointDeviation& point : points) {
        *row = {point.distance, {}, 0, point.beside, point.certain};
        for (unsigned k = 0; k < 3; ++k) row->closest[k] = point.closest[k];
        if (point.face != no_index) row->face = scene.face_id(faces[point.face].face);
        ++row;
    }
    return array;
}

/// The document, the page with its maps, and the deviations.
py::tuple compare(const OpenScene& open, const NumberRows& array, const std::string& name,
                  std::optional<double> tolerance, double least_share, bool align, double reach,
                  const std::optional<std::vector<std::string>>& views, const py::object& progress,
                  int threads) {
    const std::vector<Vec3> points = points_of(array);
    CompareScanOptions options;
    options.scan = name, options.limits = {tolerance, least_share};
    options.align = align, options.reach = reach;
    if (views) options.views = ScanViewsOptions{*views};
    ScanResult result = run({progress, threads}, [&](const Job& job) {
        return compare_points(*open.scene, points, options, job);
    });
    return py::make_tuple(scan_json(result.comparison), scan_html(result.comparison),
                          rows_of(*open.scene, result.points));
}

/// The points of a file as n rows of 3.
py::array read(const std::filesystem::path& file, double millimetres) {
    const std::vector<Vec3> points = read_scan(file, millimetres);
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
    auto rows = array.mutable_unchecked<2>();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (unsigned k = 0; k < 3; ++k) rows(static_cast<py::ssize_t>(i), k) = points[i][k];
    return array;
}

} // namespace

void add_scans(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(DeviationRow, distance, closest, face, beside, certain);
    module.def("scan_deviations", &compare);
    module.def("scan_points", &read);
}

} // namespace keiko::python
