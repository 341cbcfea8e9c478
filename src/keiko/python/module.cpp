#include "keiko/python/module.h"

#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/text.h"

#include <pybind11/stl/filesystem.h>

#include <exception>
#include <utility>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// keiko.Error of C++'s: one line, with its parts as attributes.
void raise(const py::object& type, const Error& error) {
    const py::object raised = type(error.what());
    raised.attr("file") = error.file();
    raised.attr("where") = error.where();
    raised.attr("reason") = error.reason();
    PyErr_SetObject(type.ptr(), raised.ptr());
}

} // namespace

std::string shown(const py::object& value) {
    constexpr std::size_t most = 60; // bytes
    return shortened(py::repr(value).cast<std::string>(), most);
}

std::filesystem::path path_of(const py::object& input) {
    const auto refuse = [&] { throw py::type_error("a path is needed, not " + shown(input)); };
    if (!py::isinstance<py::str>(input) && !py::hasattr(input, "__fspath__")) refuse();
    if (py::isinstance<py::str>(input) && input.contains("\n"))
        throw FieldError("input",
                         "is a text of several lines, no path: a body's goes to keiko.load "
                         "as bytes, a rig's to keiko.Rig");
    try {
        return input.cast<std::filesystem::path>();
    } catch (const py::cast_error&) {
        refuse();
    }
    return {};
}

std::vector<std::filesystem::path> paths_of(const py::object& input) {
    if (py::isinstance<py::str>(input) || py::hasattr(input, "__fspath__")) return {path_of(input)};
    if (!py::isinstance<py::sequence>(input)) return {path_of(input)}; // raises
    std::vector<std::filesystem::path> paths;
    for (const py::handle& one : input)
        paths.push_back(path_of(py::reinterpret_borrow<py::object>(one)));
    if (paths.empty()) throw FieldError("input", "no file is named");
    return paths;
}

void require_no_reading(const std::string& unit, const std::string& axes) {
    if (!unit.empty() || !axes.empty())
        throw FieldError(unit.empty() ? "axes" : "unit", "a Model has been read already");
}

std::vector<Ray> rays_of(const NumberRows& array, const char* field, const char* meaning) {
    if (array.ndim() != 2 || array.shape(1) != 6)
        throw FieldError(field, std::string("an array of n rows of 6 is needed: ") + meaning);
    const auto numbers = array.unchecked<2>();
    std::vector<Ray> rays(static_cast<std::size_t>(array.shape(0)));
    for (py::ssize_t i = 0; i < array.shape(0); ++i) {
        const auto at = [&](py::ssize_t k) { return numbers(i, k); };
        Ray& ray = rays[static_cast<std::size_t>(i)];
        ray.origin = {at(0), at(1), at(2)}, ray.direction = {at(3), at(4), at(5)};
    }
    return rays;
}

} // namespace keiko::python

PYBIND11_MODULE(_keiko, module) {
    static py::object error = py::reinterpret_borrow<py::object>(
        PyErr_NewExceptionWithDoc("keiko.Error", "Bad input; one line that names file and reason.",
                                  PyExc_ValueError, nullptr));
    module.attr("Error") = error;
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(std::move(thrown));
        } catch (const keiko::Error& e) {
            keiko::python::raise(error, e);
        }
    });
    module.def("version", &keiko::version, "Version of Keiko, as 0.1.0.");
    keiko::python::add_models(module);
    keiko::python::add_rigs(module);
    keiko::python::add_curves(module);
    keiko::python::add_lines(module);
    keiko::python::add_drawings(module);
    keiko::python::add_scenes(module);
    keiko::python::add_inspections(module);
    keiko::python::add_pictures(module);
    keiko::python::add_analyses(module);
    keiko::python::add_meshes(module);
    keiko::python::add_mesh_errors(module);
    keiko::python::add_scans(module);
    keiko::python::add_comparisons(module);
    keiko::python::add_verbs(module);
}
