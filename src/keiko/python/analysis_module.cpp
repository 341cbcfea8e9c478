#include "keiko/api/render.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <array>
#include <cmath>
#include <utility>

namespace py = pybind11;

namespace keiko::python {
namespace {

Vec3 direction_of(const py::dict& given, const char* name) {
    const auto parts = taken<std::array<double, 3>>(given, name);
    const Vec3 direction(parts[0], parts[1], parts[2]);
    if (const double length = direction.length(); !(length > 0) || !std::isfinite(length))
        throw FieldError(name, "is no direction");
    return direction.normalized();
}

/// A mode with its settings, from keyword arguments. Throws FieldError naming the argument.
ChosenMode mode_of(const std::string& look, const py::dict& given) {
    const StatedLook stated = look_from(look);
    if (stated.full) throw FieldError("look", "the curvature of full colour is that of scale");
    ChosenMode mode{stated.mode, {}, direction_of(given, "section")};
    AnalysisOptions& options = mode.options;
    options.pull = direction_of(given, "pull");
    options.draft = taken<double>(given, "draft");
    if (!(options.draft >= 0 && options.draft <= 90)) throw FieldError("draft", "is not 0 to 90");
    const auto radius = taken<std::optional<double>>(given, "radius");
    if (mode.look == AnalysisMode::below_radius && !radius) throw FieldError("radius", "is needed");
    options.radius = radius.value_or(options.radius);
    if (!(options.radius > 0 && std::isfinite(options.radius)))
        throw FieldError("radius", "is not above 0 mm");
    const auto scale = taken<std::optional<std::pair<double, double>>>(given, "scale");
    if (scale && !(scale->first < scale->second && std::isfinite(scale->second - scale->first)))
        throw FieldError("scale", "does not rise from one number to another");
    if (scale && mode.look == AnalysisMode::radius && !(scale->first > 0))
        throw FieldError("scale", "is not above 0 mm");
    if (scale) options.scale.range = ValueRange{scale->first, scale->second};
    return mode;
}

py::bytes analysis(const OpenScene& open, const std::string& look, const std::string& view,
                   const py::object& rig, std::optional<int> width, std::optional<int> height,
                   const py::dict& given, const py::object& progress, int threads) {
    const ChosenMode mode = mode_of(look, given);
    const ChosenRig chosen(rig);
    return run({progress, threads}, [&](const Job& job) {
        const NamedView seen = view_named(*open.scene, view, width, height, job);
        LightRig lamps;
        if (mode.look == AnalysisMode::highlight) lamps = lamps_of(*open.scene, chosen, seen, job);
        return encode_png(scene_analysis(*open.scene, seen.camera, lamps, mode, job));
    });
}

} // namespace

void add_analyses(py::module_& module) {
    module.def("analysis_png", &analysis);
}

} // namespace keiko::python
