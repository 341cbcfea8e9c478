#include "keiko/api/light.h"
#include "keiko/api/model.h"
#include "keiko/api/place.h"
#include "keiko/api/regress.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/solution.h"
#include "keiko/python/work.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <map>
#include <memory>
#include <utility>

namespace py = pybind11;

namespace keiko::python {
namespace {

/// Placed lamps, and the share of the body that mirrors them.
struct PlacedLamps {
    LightRig rig;
    double coverage = 0;
    std::vector<std::string> remarks;
};

LampKind kind_named(const std::string& name) {
    for (const LampKind kind : lamp_kinds)
        if (name_of(kind) == name) return kind;
    throw FieldError("lamp", "is tube, panel or screen, not " + name);
}

PlacedLamps place(const OpenScene& open, const std::vector<std::string>& views,
                  const std::string& lamp, int lamps, int planes, const py::object& progress,
                  int threads) {
    const LampKind kind = kind_named(lamp);
    return run({progress, threads}, [&](const Job& job) {
        PlaceOptions options;
        options.views = views;
        options.placement.kind = kind, options.placement.lamps = lamps,
        options.placement.planes = planes;
        Placement placement = place_scene(*open.scene, options, job).placement;
        PlacedLamps placed{std::move(placement.rig), placement.coverage, {}};
        for (const Diagnostic& remark : placement.diagnostics)
            placed.remarks.push_back(remark.entity + ": " + remark.message);
        return placed;
    });
}

std::string info(const py::object& input, const std::string& unit, const std::string& axes,
                 double join, const py::object& progress, int threads) {
    const std::shared_ptr<const SurfaceModel> model = model_of(input);
    const auto file = model ? std::filesystem::path() : path_of(input);
    if (model) require_no_reading(unit, axes);
    return run({progress, threads}, [&](const Job& job) {
        FactsOptions options;
        options.load.unit = unit, options.load.axes = axes, options.join = require_join(join);
        return facts_json(model ? body_info(*model, options, job) : model_info(file, options, job));
    });
}

std::string regress(const std::filesystem::path& suite, const std::filesystem::path& output,
                    const std::filesystem::path& baselines, const std::vector<std::string>& only,
                    bool fresh, const py::object& progress, int threads) {
    return run({progress, threads}, [&](const Job& job) {
        RegressOptions options;
        options.suite = suite, options.output = output, options.baselines = baselines;
        options.only = only, options.fresh = fresh;
        return regression_json(run_regression(options, job));
    });
}

/// Changes of each new baseline, one line each, by the name of its fixture.
std::map<std::string, std::vector<std::string>> accept_baselines(
    const std::filesystem::path& suite, const std::vector<std::string>& names,
    const std::string& by, const std::string& reason, const std::filesystem::path& output,
    const std::filesystem::path& baselines, const py::object& progress, int threads) {
    return run({progress, threads}, [&](const Job& job) {
        RegressOptions options;
        options.suite = suite, options.output = output, options.baselines = baselines;
        std::map<std::string, std::vector<std::string>> changes;
        for (const AcceptedBaseline& one : update_baselines(options, names, by, reason, job))
            changes[one.name] = one.change.changed;
        return changes;
    });
}

/// The names of the columns, and a row of numbers a point.
py::tuple illuminance(const OpenScene& open, const NumberRows& points, const py::object& rig,
                      const py::object& solution, const py::object& progress, int threads) {
    const std::vector<Ray> at = rays_of(points, "points", "point and normal");
    const ChosenRig lamps(rig);
    const ChosenSolution light(solution);
    auto found = std::make_unique<PointIlluminance>(run({progress, threads}, [&](const Job& job) {
        const LightRig under = lamps.of(*open.scene);
        return illuminance_at(*light.lit(open, under), under, at, job);
    }));
    const py::object columns = py::cast(found->columns);
    const std::array<py::ssize_t, 2> shape{static_cast<py::ssize_t>(at.size()),
                                           static_cast<py::ssize_t>(found->columns.size())};
    const double* numbers = found->lux.data();
    const py::capsule owner(found.release(),
                            [](void* p) { delete static_cast<PointIlluminance*>(p); });
    return py::make_tuple(columns, py::array_t<double>(shape, numbers, owner));
}

} // namespace

void add_verbs(py::module_& module) {
    add_radiosity(module);
    py::class_<PlacedLamps>(module, "Placement",
                            "Placed lamps, and how much of the body mirrors them.")
        .def_readonly("coverage", &PlacedLamps::coverage,
                      "Share of the body that mirrors the lamps, 0 to 1.")
        .def_readonly("remarks", &PlacedLamps::remarks,
                      "What is worth knowing about the placement, a text each.")
        .def_property_readonly(
            "rig",
            [](const PlacedLamps& placed) {
                return py::module_::import("keiko").attr("Rig")(rig_text(placed.rig));
            },
            "The lamps, a Rig.");
    module.def("place_lamps", &place);
    module.def("info_json", &info);
    module.def("regress_json", &regress);
    module.def("accept_baselines", &accept_baselines, py::arg("suite"), py::arg("names"),
               py::kw_only(), py::arg("by"), py::arg("reason"), py::arg("output") = "keiko-regress",
               py::arg("baselines") = "", py::arg("progress") = py::none(), py::arg("threads") = 0,
               "Makes the results of fixtures their baselines: what each new one changes, by "
               "fixture.\n\n`names` are of fixtures in the suite. `by` and `reason` are written "
               "into the baselines.");
    module.def("illuminance_numbers", &illuminance);
}

} // namespace keiko::python
