#include "keiko/report/content/line_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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

/// Checks of all views, and acceptances of lines that cover none.
struct JudgedLines {
    std::vector<Check> checks;
    std::vector<AcceptanceRemark> remarks;
};

JudgedLines judged_lines(const LineList& list) {
    JudgedLines judged;
    AcceptanceList of_lines{{}, list.acceptances.today};
    for (const ViewLines& view : list.views) {
        add_view(view, judged.checks);
        for (const Acceptance& entry : list.acceptances.entries)
            if (!entry.view.empty() && entry.view == view.view) of_lines.entries.push_back(entry);
    }
    judged.remarks = accept(judged.checks, of_lines, {});
    return judged;
}

} // namespace

CrossingCounts count_crossings(const LineList& list) {
    CrossingCounts counts;
    for (const ViewLines& view : list.views) {
        counts.out_of_scope += view.found.out_of_scope;
        for (const LineCrossing& crossing : view.found.crossings) {
            if (!crossing.verdict)
                ++counts.not_judged;
            else if (*crossing.verdict == Verdict::fail)
                ++counts.fail;
            else
                ++(*crossing.verdict == Verdict::pass ? counts.pass : counts.undecided);
        }
    }
    return counts;
}

Verdict verdict_of(const LineList& list) {
    const CrossingCounts counts = count_crossings(list);
    const Verdict measured = counts.fail > 0        ? Verdict::fail
                             : counts.undecided > 0 ? Verdict::undecided
                                                    : Verdict::pass;
    if (measured == Verdict::pass || list.acceptances.entries.empty()) return measured;
    WorstChecks worst;
    for (const Check& check : line_checks(list))
        if (check.is_finding() || check.is_accepted()) worst.add(check);
    return worst.left_of(measured);
}

std::vector<CrossingPlace> ranked_crossings(const LineList& list) {
    std::vector<CrossingPlace> places;
    for (std::size_t v = 0; v < list.views.size(); ++v)
        for (std::size_t c = 0; c < list.views[v].found.crossings.size(); ++c)
            if (list.views[v].found.crossings[c].verdict) places.push_back({v, c});
    std::stable_sort(places.begin(), places.end(),
                     [&](const CrossingPlace& a, const CrossingPlace& b) {
                         const LineCrossing &of_a = a.in(list), &of_b = b.in(list);
                         if (*of_a.verdict != *of_b.verdict) return *of_a.verdict > *of_b.verdict;
                         return of_a.severity > of_b.severity;
                     });
    return places;
}

std::vector<Check> line_checks(const LineList& list) {
    return judged_lines(list).checks;
}

Inspection with_lines(Inspection inspection, const LineList& list) {
    inspection.verdict = std::max(inspection.verdict, verdict_of(list));
    JudgedLines lines = judged_lines(list);
    std::move(lines.remarks.begin(), lines.remarks.end(),
              std::back_inserter(inspection.acceptance_remarks));
    for (Check& check : lines.checks) {
        if (check.is_finding()) inspection.findings.push_back(check);
        if (check.is_accepted()) inspection.accepted.push_back(check);
        inspection.checks.push_back(std::move(check));
    }
    return inspection;
}

} // namespace keiko
