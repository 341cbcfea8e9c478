#include "keiko/report/content/line_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

namespace keiko {
namespace {

struct LineCriterion {
    std::string_view code;
    LineValue LineCrossing::*value;
    bool of_breaks; ///< known if a line is not continued too
};
constexpr std::array criteria{LineCriterion{"KEIKO-LINE-TURN", &LineCrossing::turn, true},
                              LineCriterion{"KEIKO-LINE-JUMP", &LineCrossing::jump, false},
                              LineCriterion{"KEIKO-LINE-KINK", &LineCrossing::kink, false},
                              LineCriterion{"KEIKO-LINE-BEND", &LineCrossing::bend, false}};

/// Crossings of one seam by one criterion.
struct Tally {
    MeasuredValue worst;
    std::size_t lines = 0, failing = 0;

    void add(const LineValue& value, const Vec3& place) {
        const MeasuredValue one{std::abs(value.value), value.bound, *value.limit, place,
                                value.verdict,         false};
        failing += value.verdict == Verdict::pass ? 0 : 1;
        const bool worse =
            one.verdict != worst.verdict ? one.verdict > worst.verdict : one.value > worst.value;
        if (lines++ == 0 || worse) worst = one;
    }
};

void add_view(const ViewLines& view, std::vector<Check>& checks) {
    std::map<std::string, std::array<Tally, criteria.size()>> seams;
    for (const LineCrossing& crossing : view.found.crossings) {
        if (!crossing.verdict) continue;
        auto& tallies = seams[crossing.faces];
        for (std::size_t i = 0; i < criteria.size(); ++i) {
            const LineValue& value = crossing.*criteria[i].value;
            if (value.limit && (crossing.continued() || criteria[i].of_breaks))
                tallies[i].add(value, crossing.place);
        }
    }
    for (const auto& [faces, tallies] : seams)
        for (std::size_t i = 0; i < criteria.size(); ++i) {
            const Tally& tally = tallies[i];
            if (tally.lines == 0) continue;
            Check check = check_of_lines(criteria[i].code, tally.worst, tally.lines, tally.failing);
            check.view = view.view, check.faces = faces;
            checks.push_back(std::move(check));
        }
}

} // namespace

std::vector<Check> line_checks(const LineList& list) {
    std::vector<Check> checks;
    for (const ViewLines& view : list.views) add_view(view, checks);
    return checks;
}

Inspection with_lines(Inspection inspection, const LineList& list) {
    for (Check& check : line_checks(list)) {
        inspection.verdict = std::max(inspection.verdict, check.worst.verdict);
        if (check.is_finding()) inspection.findings.push_back(check);
        inspection.checks.push_back(std::move(check));
    }
    return inspection;
}

} // namespace keiko
