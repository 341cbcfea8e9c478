#include "keiko/compare/compare_inspections.h"

#include "keiko/patch/surface_model.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace keiko {
namespace {

/// partner[i] is the other side's seam, or no_index.
struct Matching {
    std::vector<std::uint32_t> of_before, of_after;
};

Matching match_seams(const Inspection& before, const Inspection& after, double reach) {
    struct Pair {
        bool renamed;
        double distance;
        std::uint32_t before, after;
    };
    std::vector<Pair> pairs;
    for (std::uint32_t i = 0; i < before.seams.size(); ++i)
        for (std::uint32_t j = 0; j < after.seams.size(); ++j) {
            const MeasuredSeam &a = before.seams[i], &b = after.seams[j];
            const double distance = (a.middle - b.middle).length();
            if (distance <= reach) pairs.push_back({a.faces != b.faces, distance, i, j});
        }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
        return std::tie(x.renamed, x.distance, x.before, x.after) <
               std::tie(y.renamed, y.distance, y.before, y.after);
    });
    Matching matching{std::vector(before.seams.size(), no_index),
                      std::vector(after.seams.size(), no_index)};
    for (const Pair& pair : pairs) {
        std::uint32_t &i = matching.of_before[pair.before], &j = matching.of_after[pair.after];
        if (i == no_index && j == no_index) i = pair.after, j = pair.before;
    }
    return matching;
}

SeamChange change_between(const Inspection& before, const Inspection& after, std::uint32_t i,
                          std::uint32_t j) {
    const MeasuredSeam &a = before.seams[i], &b = after.seams[j];
    const double angle = a.angle && b.angle ? b.angle->value - a.angle->value : 0;
    return {i, j, b.gap.value - a.gap.value, angle, a.verdict, b.verdict};
}

std::vector<std::uint32_t> unmatched(const std::vector<std::uint32_t>& partners) {
    std::vector<std::uint32_t> alone;
    for (std::uint32_t i = 0; i < partners.size(); ++i)
        if (partners[i] == no_index) alone.push_back(i);
    return alone;
}

/// The findings of `one` whose seam has no partner with a finding of the same code in `other`.
std::vector<Check> only_in(const Inspection& one, const Inspection& other,
                           const std::vector<std::uint32_t>& partners) {
    std::vector<Check> only;
    for (const Check& finding : one.findings) {
        const std::uint32_t partner = partners[finding.seam];
        const bool known = std::any_of(
            other.findings.begin(), other.findings.end(),
            [&](const Check& f) { return f.seam == partner && f.code == finding.code; });
        if (!known) only.push_back(finding);
    }
    return only;
}

} // namespace

InspectionDifference compare_inspections(const Inspection& before, const Inspection& after,
                                         const CompareOptions& options) {
    const Matching matching = match_seams(before, after, options.place);
    InspectionDifference difference;
    for (std::uint32_t i = 0; i < before.seams.size(); ++i) {
        const std::uint32_t j = matching.of_before[i];
        if (j == no_index) continue;
        ++difference.matched;
        const SeamChange change = change_between(before, after, i, j);
        if (std::abs(change.gap) > options.gap || std::abs(change.angle) > options.angle ||
            change.verdict_before != change.verdict_after)
            difference.changed.push_back(change);
    }
    difference.removed = unmatched(matching.of_before);
    difference.added = unmatched(matching.of_after);
    difference.new_findings = only_in(after, before, matching.of_after);
    difference.solved_findings = only_in(before, after, matching.of_before);
    return difference;
}

} // namespace keiko
