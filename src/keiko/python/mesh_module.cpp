#include "keiko/api/model.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <memory>
#include <utility>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// Vectors as NumPy sees them, n rows of 3, without a copy.
template <class Row, class Number>
py::array rows_of(const std::vector<Row>& rows, const Number* data, const py::object& owner) {
    static_assert(sizeof(Row) == 3 * sizeof(Number));
    return py::array_t<Number>({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}}, data,
                               owner);
}

py::array vectors_of(const std::vector<Vec3>& vectors, const py::object& owner) {
    return rows_of(vectors, vectors.empty() ? nullptr : &vectors.front().x, owner);
}

py::dict fields_of(const py::object& owner) {
    py::dict fields;
    for (const MeshField& field : owner.cast<const SurfaceMesh&>().fields)
        fields[py::str(field.name)] = py::array_t<double>(
            static_cast<py::ssize_t>(field.values.size()), field.values.data(), owner);
    return fields;
}

SurfaceMesh mesh(const OpenScene& open, double deviation, const std::vector<std::string>& fields,
                 const std::array<double, 3>& pull, const OpenScene* against, double reach,
                 const py::object& progress, int threads) {
    MeshOptions options;
    options.deviation = deviation, options.reach = reach;
    options.pull = {pull[0], pull[1], pull[2]};
    for (const std::string& name : fields) options.fields.push_back(surface_field_by_name(name));
    if (against) options.against = against->scene.get();
    return run({progress, threads},
               [&](const Job& job) { return surface_mesh(*open.scene, options, job); });
}

using Range = std::optional<std::pair<double, double>>;

std::optional<ValueRange> range_of(const Range& range) {
    if (range && !(range->first < range->second && std::isfinite(range->second - range->first)))
        throw FieldError("range", "does not rise from one number to another");
    return range ? std::optional(ValueRange{range->first, range->second}) : std::nullopt;
}

} // namespace

void add_meshes(py::module_& module) {
    py::class_<SurfaceMesh>(module, "Mesh",
                            "A body in triangles whose corners lie on the exact surface.")
        .def_property_readonly(
            "points",
            [](const py::object& mesh) {
                return vectors_of(mesh.cast<const SurfaceMesh&>().positions, mesh);
            },
            "Corners in mm, (n, 3).")
        .def_property_readonly(
            "normals",
            [](const py::object& mesh) {
                return vectors_of(mesh.cast<const SurfaceMesh&>().normals, mesh);
            },
            "Unit normals of the exact surface at the corners, (n, 3).")
        .def_property_readonly(
            "triangles",
            [](const py::object& mesh) {
                const auto& rows = mesh.cast<const SurfaceMesh&>().triangles;
                return rows_of(rows, rows.empty() ? nullptr : rows.front().data(), mesh);
            },
            "Indices of the corners of each triangle, (m, 3).")
        .def_property_readonly(
            "faces",
            [](const py::object& mesh) {
                const auto& faces = mesh.cast<const SurfaceMesh&>().faces;
                return py::array_t<std::uint32_t>(static_cast<py::ssize_t>(faces.size()),
                                                  faces.data(), mesh);
            },
            "Number of the face of each triangle, (m).")
        .def_property_readonly("fields", &fields_of, "Numbers at the corners by name, (n) each.")
        .def_readonly("deviation", &SurfaceMesh::deviation,
                      "Distance in mm by which the surface leaves the triangles, about.")
        .def_readonly("lost_faces", &SurfaceMesh::lost_faces, "Why faces were lost, a text each.")
        .def(
            "vtp", [](const SurfaceMesh& mesh) { return py::bytes(vtp_file(mesh)); },
            "Bytes of a VTK file with all fields.")
        .def(
            "ply",
            [](const SurfaceMesh& mesh, const Range& range) {
                return py::bytes(ply_file(mesh, range_of(range)));
            },
            py::arg("range") = py::none(),
            "Bytes of a PLY file, coloured by the first field over a range (low, high), by default "
            "its own.")
        .def(
            "glb",
            [](const SurfaceMesh& mesh, const Range& range) {
                return py::bytes(glb_file(mesh, range_of(range)));
            },
            py::arg("range") = py::none(), "Bytes of a binary glTF file, coloured as `ply` is.");
    module.def("surface_mesh", &mesh);
}

} // namespace keiko::python
