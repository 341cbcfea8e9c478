#pragma once

#include "keiko/api/scene.h"

#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace keiko::python {

/// An open scene, and what opens it again in another process.
struct OpenScene {
    std::vector<std::filesystem::path> paths; ///< models of one body, or one scene file
    std::string unit, axes;                   ///< as LoadOptions
    std::string material;                     ///< as SceneOptions
    bool shadows = false;                     ///< as SceneOptions
    std::shared_ptr<const Scene> scene;       ///< never null once it is open
};

/// Paths of one path, or of a sequence of paths. Raises TypeError for anything else.
std::vector<std::filesystem::path> paths_of(const pybind11::object& input);

/// The class Scene, what it traces, and the function open_scene.
void add_scenes(pybind11::module_& module);
/// The functions check and inspect, and the class ReportTexts.
void add_inspections(pybind11::module_& module);
/// The functions place, lines, compare, info, regress and illuminance.
void add_verbs(pybind11::module_& module);
/// The function render and the class Film.
void add_pictures(pybind11::module_& module);

} // namespace keiko::python
