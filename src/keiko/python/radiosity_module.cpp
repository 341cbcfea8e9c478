#include "keiko/base/error.h"
#include "keiko/python/solution.h"
#include "keiko/python/work.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <string>
#include <utility>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// A solution at hand, of no file.
constexpr const char* at_hand = "solution";

double lumens(const OpenSolution& open, Rgb EnergyBalance::*part) {
    return luminance(open.solution->balance.*part);
}

OpenSolution solve(const OpenScene& open, const py::object& rig, const py::object& progress,
                   int threads) {
    const ChosenRig lamps(rig);
    return run({progress, threads}, [&](const Job& job) {
        Scene scene = *open.scene;
        scene.rig = lamps.of(scene);
        OpenSolution solved{nullptr, at_hand, {}};
        for (const Diagnostic& remark : radiosity_remarks(scene))
            solved.remarks.push_back(remark.entity + ": " + remark.message);
        // As a file has it, in single precision: results are the same by way of a file.
        const std::string text = solution_text(solve_radiosity(scene, job));
        solved.solution = std::make_shared<const RadiositySolution>(parse_solution(text, at_hand));
        return solved;
    });
}

OpenSolution read(const py::object& file) {
    const std::filesystem::path path = path_of(file);
    return {std::make_shared<const RadiositySolution>(read_solution(path)), path.string(), {}};
}

} // namespace

ChosenSolution::ChosenSolution(const py::object& given) {
    if (given.is_none()) return;
    if (py::isinstance<OpenSolution>(given))
        open_ = given.cast<const OpenSolution&>();
    else
        open_ = read(given);
}

std::shared_ptr<const Scene> ChosenSolution::lit(const OpenScene& open, const LightRig& rig) const {
    if (!open_) return open.scene;
    if (!open.scene->occluders)
        throw FieldError("solution", "is for a scene opened with shadows=True");
    Scene scene = *open.scene;
    scene.reflected = reflected_light(scene, rig, *open_->solution, open_->source);
    return std::make_shared<const Scene>(std::move(scene));
}

void add_radiosity(py::module_& module) {
    py::class_<OpenSolution>(module, "Solution",
                             "Light that the diffuse surfaces of a scene reflect onto each other. "
                             "keiko.radiosity solves it; illuminance and render take it.")
        .def_static("read", &read, py::arg("file"),
                    "The solution of a file, as keiko radiosity writes it.")
        .def(
            "write",
            [](const OpenSolution& open, const py::object& file) {
                write_solution(path_of(file), *open.solution);
            },
            py::arg("file"), "Writes the file, keiko-solution/1.")
        .def_property_readonly(
            "elements", [](const OpenSolution& open) { return open.solution->elements; },
            "Number of elements of the scene.")
        .def_property_readonly(
            "factor_rows", [](const OpenSolution& open) { return open.solution->factor_rows; },
            "Number of rows of form factors that were computed for it.")
        .def_property_readonly(
            "emitted",
            [](const OpenSolution& open) { return lumens(open, &EnergyBalance::emitted); },
            "Light that elements reflect first, lm, at the levels of the lamps when it was solved.")
        .def_property_readonly(
            "absorbed",
            [](const OpenSolution& open) { return lumens(open, &EnergyBalance::absorbed); },
            "What elements absorb of it, lm.")
        .def_property_readonly(
            "escaped",
            [](const OpenSolution& open) { return lumens(open, &EnergyBalance::escaped); },
            "What leaves the scene of it, lm.")
        .def_property_readonly(
            "missing",
            [](const OpenSolution& open) { return luminance(open.solution->balance.missing()); },
            "What is neither absorbed nor leaves the scene, lm: 0 for exact radiosities.")
        .def_property_readonly(
            "remaining", [](const OpenSolution& open) { return open.solution->remaining; },
            "Bound of the light that it lacks, as a share of its own.")
        .def_readonly("remarks", &OpenSolution::remarks,
                      "What it leaves out of the scene's light, a text each; none if it was read.")
        .def(py::pickle(
            [](const OpenSolution& open) {
                return py::make_tuple(solution_text(*open.solution), open.source, open.remarks);
            },
            [](const py::tuple& state) {
                const auto text = state[0].cast<std::string>(),
                           source = state[1].cast<std::string>();
                auto solution =
                    std::make_shared<const RadiositySolution>(parse_solution(text, source));
                return OpenSolution{std::move(solution), source,
                                    state[2].cast<std::vector<std::string>>()};
            }));
    module.def("solved_radiosity", &solve);
}

} // namespace keiko::python
