#include "keiko/inspect/joints/joint_run.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

} // namespace

std::optional<JointSection> JointRuns::section(std::uint32_t border, double t,
                                               std::size_t other) const {
    const AcrossResult found = measure_across(borders_, borders_.all()[border], t, limits_);
    return found.section && found.body == other ? found.section : std::nullopt;
}

/// Both ends, and places about evenly spaced between them.
std::vector<double> JointRuns::parameters(std::uint32_t border) const {
    constexpr double least_steps = 8; // but on borders shorter than `spacing`
    const CurvePolyline& line = borders_.all()[border].polyline;
    const double spacings = line.length / limits_.spacing;
    const double steps =
        std::ceil(std::max({1.0, spacings, std::min(least_steps, least_steps * spacings)}));
    std::vector<double> found{0};
    double way = 0, number = 1;
    for (std::size_t i = 0; i + 1 < line.t.size(); ++i) {
        const double length = (line.points[i + 1] - line.points[i]).length();
        for (; number < steps && number / steps * line.length <= way + length; ++number) {
            const double share = length > 0 ? (number / steps * line.length - way) / length : 0;
            found.push_back(line.t[i] + share * (line.t[i + 1] - line.t[i]));
        }
        way += length;
    }
    found.push_back(1);
    return found;
}

/// Follows a run towards parameters at which it is over; NaN: there are none.
void JointRuns::extend(JointRun& run, double before, double after) const {
    const auto any = [](const JointSection&) { return true; };
    const auto last_towards = [&](const JointStation& from, double bad) {
        return from.section && !std::isnan(bad)
                   ? last_good(from.border, from.t, bad, run.other, any)
                   : std::nullopt;
    };
    const auto first = last_towards(run.stations.front(), before);
    const auto last = last_towards(run.stations.back(), after);
    if (first) run.stations.insert(run.stations.begin(), *first);
    if (last) run.stations.push_back(*last);
}

std::vector<JointRun> JointRuns::of(std::uint32_t border) const {
    const PanelBorder& line = borders_.all()[border];
    std::vector<JointRun> runs;
    std::vector<std::array<double, 2>> beyond; // the parameters before and after a run
    double before = nowhere;
    bool goes_on = false;
    for (const double t : parameters(border)) {
        check_stop();
        const AcrossResult found = measure_across(borders_, line, t, limits_);
        const bool counts = (found.section || found.is_unmeasured) && found.body > line.body;
        if (goes_on && !(counts && found.body == runs.back().other)) beyond.back()[1] = t;
        if (counts && !(goes_on && found.body == runs.back().other)) {
            runs.push_back({line.body, found.body, {}});
            beyond.push_back({before, nowhere});
        }
        if (counts)
            runs.back().stations.push_back(
                {border, t, line.curve.at(t).position, 0, found.section});
        goes_on = counts, before = t;
    }
    for (std::size_t i = 0; i < runs.size(); ++i) extend(runs[i], beyond[i][0], beyond[i][1]);
    return runs;
}

} // namespace keiko
