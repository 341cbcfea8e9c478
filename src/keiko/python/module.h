#pragma once

#include "keiko/api/check.h"
#include "keiko/api/scene.h"
#include "keiko/api/trace.h"
#include "keiko/api/view.h"
#include "keiko/base/output_folder.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace keiko::python {

/// A body that has been read.
struct OpenModel {
    std::shared_ptr<const SurfaceModel> model; ///< never null
    std::vector<std::filesystem::path> paths;  ///< that it was read from; none: from bytes
};

/// An open scene, and what opens it again in another process.
struct OpenScene {
    std::vector<std::filesystem::path> paths;  ///< models of one body, or one scene file
    std::shared_ptr<const SurfaceModel> model; ///< that it was made of instead; null: of the paths
    std::string unit, axes;                    ///< as LoadOptions
    std::string material;                      ///< as SceneOptions
    bool shadows = false;                      ///< as SceneOptions
    double frame = 0;                          ///< as SceneOptions
    std::shared_ptr<const Scene> scene;        ///< never null once it is open
};

/// Rows of numbers of any array that NumPy can make one of.
using NumberRows = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Rays of an array of n rows of six: origin and direction, or point and normal. Throws FieldError
/// for another shape; `meaning`: what a row holds.
std::vector<Ray> rays_of(const NumberRows& array, const char* field, const char* meaning);

/// Paths of one path, or of a sequence of paths. Raises TypeError for anything else, and Error for
/// an empty sequence and as path_of.
std::vector<std::filesystem::path> paths_of(const pybind11::object& input);

/// Path of one path. Raises TypeError for anything else, and Error for a text of several lines.
std::filesystem::path path_of(const pybind11::object& input);

/// The beginning of what Python shows of a value, in one line.
std::string shown(const pybind11::object& value);

/// Words for an error on what an argument must be.
template <class Value>
constexpr const char* meaning_of() {
    if constexpr (std::is_same_v<Value, bool>) return "True or False";
    if constexpr (std::is_same_v<Value, int>) return "a whole number";
    if constexpr (std::is_same_v<Value, double>) return "a number";
    if constexpr (std::is_same_v<Value, std::string>) return "a text";
    if constexpr (std::is_same_v<Value, std::vector<std::string>>) return "a sequence of texts";
    if constexpr (std::is_same_v<Value, std::array<double, 3>>) return "three numbers";
    if constexpr (std::is_same_v<Value, std::optional<double>>) return "a number or None";
    if constexpr (std::is_same_v<Value, std::optional<std::pair<double, double>>>)
        return "two numbers or None";
    if constexpr (std::is_same_v<Value, std::optional<std::vector<std::string>>>)
        return "a sequence of texts or None";
    if constexpr (std::is_same_v<Value, std::optional<std::filesystem::path>>)
        return "a path or None";
}

/// The value of a keyword argument. Raises TypeError naming the argument if it has another type.
template <class Value>
Value taken(const pybind11::dict& arguments, const char* name) {
    const pybind11::object given = arguments[name];
    try {
        return given.cast<Value>();
    } catch (const pybind11::cast_error&) {
        throw pybind11::type_error(std::string(name) + ": " + meaning_of<Value>() +
                                   " is needed, not " + shown(given));
    }
}

/// The distance within which borders are a seam, mm. Throws Error unless it is 1e-6 to 1000.
double require_join(double join);

/// The part of a body that is judged, from keyword arguments. Throws Error naming the argument.
Scope scope_of(const pybind11::dict& arguments);

/// Files of a folder by name.
pybind11::dict bytes_of(const FolderContent& content);

/// Number, name and layer of each face.
pybind11::list faces_of(const SurfaceModel& model);
/// Why faces were lost, a reason each.
std::vector<std::string> losses_of(const SurfaceModel& model);
/// Lowest and highest corner of a box, mm: 2 x 3.
pybind11::array corners_of(const Box3& box);
/// The body of a Model or a Scene; null for anything else.
std::shared_ptr<const SurfaceModel> model_of(const pybind11::object& input);

/// Throws FieldError if a verb on a Model says how to read files: it has been read already.
void require_no_reading(const std::string& unit, const std::string& axes);

/// The lamps that a verb is called with: of a file, or at hand, or neither.
struct ChosenRig {
    std::optional<std::filesystem::path> file;
    std::optional<LightRig> rig;

    /// A path, a keiko.Rig, or None. Throws Error for lamps that no file can hold.
    explicit ChosenRig(const pybind11::object& rig);
    /// These lamps, or else the scene's own. Throws Error without either.
    LightRig of(const Scene& scene) const;
};

/// Throws Error unless the pixels of a side, if they are given, are 1 to 65536.
void require_size(const std::string& name, std::optional<int> pixels);

/// The view of a name, empty for the scene's own or the best; its size is the scene's where none is
/// given.
NamedView view_named(const Scene& scene, const std::string& view, std::optional<int> width,
                     std::optional<int> height, const Job& job);
/// The chosen lamps, or else the scene's own, or those that are placed for the view.
LightRig lamps_of(const Scene& scene, const ChosenRig& chosen, const NamedView& view,
                  const Job& job);

/// Calls `work(scene, file)` with the scene and the file of the lamps, or with a scene of the same
/// body that has the lamps at hand as its own.
template <class Work>
auto under(const ChosenRig& lamps, const Scene& scene, const Work& work) {
    if (!lamps.rig) return work(scene, lamps.file);
    Scene lit = scene;
    lit.rig = lamps.rig;
    return work(lit, std::optional<std::filesystem::path>());
}

/// The class Model and the functions load_model and unpickled_model.
void add_models(pybind11::module_& module);
/// The classes Curve and Spline, and the functions read_curves and write_curves.
void add_curves(pybind11::module_& module);
/// The functions rig_of_file and rig_of_text, which return the text of a rig file.
void add_rigs(pybind11::module_& module);
/// The class Scene, what it traces, and the functions open_scene and luminance_numbers.
void add_scenes(pybind11::module_& module);
/// The functions check_json, report_files, write_report and accept_findings.
void add_inspections(pybind11::module_& module);
/// The function find_lines.
void add_lines(pybind11::module_& module);
/// The class Drawing and the function draw_sheet.
void add_drawings(pybind11::module_& module);
/// The function comparison_files.
void add_comparisons(pybind11::module_& module);
/// The functions place_lamps, info_json, regress_json, accept_baselines and
/// illuminance_numbers, and what is in solution.h.
void add_verbs(pybind11::module_& module);
/// The class Mesh and the function surface_mesh.
void add_meshes(pybind11::module_& module);
/// The function mesh_error_files.
void add_mesh_errors(pybind11::module_& module);
/// The functions scan_deviations and scan_points.
void add_scans(pybind11::module_& module);
/// The function analysis_png.
void add_analyses(pybind11::module_& module);
/// The functions render_film and deep_buffer, and the classes Film and DeepBuffer.
void add_pictures(pybind11::module_& module);

} // namespace keiko::python
