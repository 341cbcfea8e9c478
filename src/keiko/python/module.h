#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <vector>

namespace keiko::python {

/// Paths of one path, or of a sequence of paths. Raises TypeError for anything else.
std::vector<std::filesystem::path> paths_of(const pybind11::object& input);

/// The class Scene, what it traces, and the function open_scene.
void add_scenes(pybind11::module_& module);
/// The functions check and inspect, and the class InspectedBody.
void add_inspections(pybind11::module_& module);
/// The functions place, lines, compare, info, regress and illuminance.
void add_verbs(pybind11::module_& module);
/// The function render and the class Picture.
void add_pictures(pybind11::module_& module);

} // namespace keiko::python
