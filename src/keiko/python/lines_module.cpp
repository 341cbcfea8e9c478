#include "keiko/api/lines.h"
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/python/module.h"
#include "keiko/python/work.h"

#include <iterator>
#include <vector>

namespace py = pybind11;

namespace keiko::python {
namespace {

LineLook look_named(const std::string& name) {
    for (const LineLook look : {LineLook::reflection, LineLook::highlight, LineLook::isophote})
        if (name_of(look) == name) return look;
    throw FieldError("look", "is reflection, highlight or isophote, not " + name);
}

LinesOptions options_of(const py::dict& given) {
    LinesOptions options;
    options.views = taken<std::vector<std::string>>(given, "views");
    options.preset = preset_by_name_or_file(taken<std::string>(given, "preset"));
    options.join = require_join(taken<double>(given, "join"));
    options.lines.look = look_named(taken<std::string>(given, "look"));
    options.lines.lines.chord_error = taken<double>(given, "chord");
    if (!(options.lines.lines.chord_error > 0)) throw FieldError("chord", "is not above 0 mm");
    options.scope = scope_of(given);
    return options;
}

/// Which curves a search for lines hands on.
struct RequestedCurves {
    bool lines = false, contours = false;

    std::vector<NamedCurve> of(const Scene& scene, const LineList& list, double chord_error,
                               const Job& job) const {
        std::vector<NamedCurve> curves;
        if (lines) curves = line_curves(list).curves;
        if (contours) {
            std::vector<NamedCurve> more = view_contours(scene, list, chord_error, job);
            std::move(more.begin(), more.end(), std::back_inserter(curves));
        }
        return curves;
    }
};

/// The document of the lines, and the requested curves.
py::tuple lines(const OpenScene& open, const py::object& rig, const py::dict& given,
                const py::object& progress, int threads) {
    const ChosenRig lamps(rig);
    const LinesOptions asked = options_of(given);
    const RequestedCurves requested{taken<bool>(given, "curves"), taken<bool>(given, "contours")};
    const auto [text, curves] = run({progress, threads}, [&](const Job& job) {
        return under(lamps, *open.scene, [&](const Scene& scene, const auto& file) {
            LinesOptions options = asked;
            options.rig = file;
            const LineList list = find_lines(scene, options, job);
            return std::pair(lines_json(list, scene.model),
                             requested.of(scene, list, options.lines.lines.chord_error, job));
        });
    });
    return py::make_tuple(text, curves);
}

} // namespace

void add_lines(py::module_& module) {
    module.def("find_lines", &lines);
}

} // namespace keiko::python
