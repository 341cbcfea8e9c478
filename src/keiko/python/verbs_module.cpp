#include "keiko/api/compare.h"
#include "keiko/api/light.h"
#include "keiko/api/lines.h"
#include "keiko/api/model.h"
#include "keiko/api/place.h"
#include "keiko/api/regress.h"
#include "keiko/api/trace.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <map>
#include <span>
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

PlacedLamps place(const OpenScene& open, const std::vector<std::string>& views, int lamps,
                  int planes, const py::object& progress, int threads) {
    return run({progress, threads}, [&](const Job& job) {
        PlaceOptions options;
        options.views = views;
        options.placement.lamps = lamps, options.placement.planes = planes;
        Placement placement = place_scene(*open.scene, options, job).placement;
        PlacedLamps placed{std::move(placement.rig), placement.coverage, {}};
        for (const Diagnostic& remark : placement.diagnostics)
            placed.remarks.push_back(remark.entity + ": " + remark.message);
        return placed;
    });
}

std::string lines(const OpenScene& open, const std::optional<std::filesystem::path>& rig,
                  const std::vector<std::string>& views, const std::string& preset, double join,
                  const py::object& progress, int threads) {
    return run({progress, threads}, [&](const Job& job) {
        LinesOptions options;
        options.views = views, options.rig = rig, options.join = join;
        options.preset = preset_by_name_or_file(preset);
        return lines_json(find_lines(*open.scene, options, job), open.scene->model);
    });
}

std::string compare(const std::filesystem::path& before, const std::filesystem::path& after,
                    const std::string& preset, double join, bool align, const py::object& progress,
                    int threads) {
    return run({progress, threads}, [&](const Job& job) {
        CompareBodiesOptions options;
        options.preset = preset_by_name_or_file(preset), options.join = join;
        options.align = align;
        return comparison_json(compare_bodies(before, after, options, job).comparison);
    });
}

std::string info(const std::filesystem::path& file, const std::string& unit,
                 const std::string& axes, double join, const py::object& progress, int threads) {
    return run({progress, threads}, [&](const Job& job) {
        FactsOptions options;
        options.load.unit = unit, options.load.axes = axes, options.join = join;
        return facts_json(model_info(file, options, job));
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

/// Lines of points and normals, as streams of points have them.
std::string point_lines(std::span<const Ray> points) {
    std::string text;
    for (const Ray& at : points)
        for (const auto& [vector, end] : {std::pair(at.origin, ','), {at.direction, '\n'}})
            for (int k = 0; k < 3; ++k) {
                append_number(text, vector[k]);
                text += k < 2 ? ',' : end;
            }
    return text;
}

/// The rows of light_points, which Python reads.
std::string illuminance(const OpenScene& open, const NumberRows& points, const py::object& progress,
                        int threads) {
    const std::vector<Ray> at = rays_of(points, "points", "point and normal");
    require_rays(at, "points", {}, point_header);
    const std::string asked = point_lines(at);
    return run({progress, threads}, [&](const Job& job) {
        std::size_t done = 0;
        std::string rows;
        light_points(
            *open.scene,
            [&](std::span<char> into) {
                const std::size_t count = asked.copy(into.data(), into.size(), done);
                done += count;
                return count;
            },
            [&](std::string_view more) {
                rows += more;
                return true;
            },
            job);
        return rows;
    });
}

} // namespace

void add_verbs(py::module_& module) {
    py::class_<PlacedLamps>(module, "Placement")
        .def_readonly("coverage", &PlacedLamps::coverage)
        .def_readonly("remarks", &PlacedLamps::remarks)
        .def_property_readonly("rig",
                               [](const PlacedLamps& placed) { return rig_text(placed.rig); });
    module.def("place", &place, py::arg("scene"), py::kw_only(),
               py::arg("views") = std::vector<std::string>{},
               py::arg("lamps") = PlacementOptions{}.lamps,
               py::arg("planes") = PlacementOptions{}.planes, py::arg("progress") = py::none(),
               py::arg("threads") = 0);
    module.def("lines_json", &lines);
    module.def("compare_json", &compare);
    module.def("info_json", &info);
    module.def("regress_json", &regress);
    module.def("accept_baselines", &accept_baselines, py::arg("suite"), py::arg("names"),
               py::kw_only(), py::arg("by"), py::arg("reason"), py::arg("output") = "keiko-regress",
               py::arg("baselines") = "", py::arg("progress") = py::none(), py::arg("threads") = 0);
    module.def("illuminance_rows", &illuminance);
}

} // namespace keiko::python
