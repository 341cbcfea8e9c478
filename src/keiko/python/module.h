#pragma once

#include "keiko/api/scene.h"
#include "keiko/api/trace.h"

#include <pybind11/numpy.h>
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

/// Rows of numbers of any array that NumPy can make one of.
using NumberRows = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Rays of an array of n rows of six: origin and direction, or point and normal. Throws FieldError
/// for another shape; `meaning`: what a row holds.
std::vector<Ray> rays_of(const NumberRows& array, const char* field, const char* meaning);

/// Paths of one path, or of a sequence of paths. Raises TypeError for anything else, and ValueError
/// for an empty sequence.
std::vector<std::filesystem::path> paths_of(const pybind11::object& input);

/// The class Scene, what it traces, and the function open_scene.
void add_scenes(pybind11::module_& module);
/// The functions check_json, report_files, write_report and accept_findings.
void add_inspections(pybind11::module_& module);
/// The functions place, lines_json, compare_json, info_json, regress_json, accept_baselines and
/// illuminance_rows.
void add_verbs(pybind11::module_& module);
/// The class Mesh and the function surface_mesh.
void add_meshes(pybind11::module_& module);
/// The functions scan_deviations and scan_points.
void add_scans(pybind11::module_& module);
/// The function render and the class Film.
void add_pictures(pybind11::module_& module);

} // namespace keiko::python
