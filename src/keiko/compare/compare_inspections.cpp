#include "keiko/compare/compare_inspections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace keiko {
namespace {

template <class T>
void keep_larger(std::optional<T>& kept, const std::optional<T>& other) {
    if (other && (!kept || *other > *kept)) kept = other;
}

/// The first quantity that a seam does not pass, in the order in which they are judged: 0 gap,
/// 1 angle or how it fades, 2 curvature, 3 its slope, 4 none. What comes after it is not judged.
int first_failed(const MeasuredSeam& seam) {
    if (seam.scrap) return 4;
    if (seam.gap.verdict != Verdict::pass) return 0;
    if (seam.fading && seam.fading->verdict != Verdict::pass) return 1;
    if (!seam.is_angle_judged()) return 4;
    if (seam.angle && seam.angle->verdict != Verdict::pass) return 1;
    if (seam.curvature && seam.curvature->worst.verdict != Verdict::pass) return 2;
    return seam.slope && seam.slope->worst.verdict != Verdict::pass ? 3 : 4;
}

int first_failed(const Inspection& inspection, const std::vector<std::uint32_t>& seams) {
    int first = 4;
    for (const std::uint32_t i : seams) first = std::min(first, first_failed(inspection.seams[i]));
    return first;
}

/// A seam that one revision divides is judged there piece by piece. Pieces that pass what the
/// others fail are judged further than the seam would be as a whole: that does not count.
SeamState state_of(const Inspection& inspection, const std::vector<std::uint32_t>& seams) {
    const int failed = first_failed(inspection, seams);
    SeamState state;
    state.severity = -1;
    for (const std::uint32_t i : seams) {
        const MeasuredSeam& seam = inspection.seams[i];
        if (seam.scrap) continue;
        state.gap = std::max(state.gap, seam.gap.value);
        if (seam.angle) keep_larger(state.angle, std::optional(seam.angle->value));
        if (first_failed(seam) > failed) continue;
        if (seam.curvature && !seam.curvature->flat)
            keep_larger(state.curvature, std::optional(seam.curvature->mismatch));
        state.verdict = std::max(state.verdict, seam.verdict);
        if (seam.severity <= state.severity) continue;
        state.severity = seam.severity;
        state.place = worst_place(seam);
    }
    return state;
}

double change(const std::optional<double>& before, const std::optional<double>& after) {
    return before && after ? *after - *before : 0;
}

SeamTrend trend_between(const SeamState& before, const SeamState& after) {
    if (before.verdict != after.verdict)
        return after.verdict > before.verdict ? SeamTrend::worse : SeamTrend::better;
    if (before.severity == after.severity) return SeamTrend::other;
    return after.severity > before.severity ? SeamTrend::worse : SeamTrend::better;
}

bool is_change(const SeamChange& c, const CompareOptions& options) {
    return c.before.verdict != c.after.verdict || std::abs(c.gap()) > options.gap ||
           std::abs(c.angle()) > options.angle || std::abs(c.curvature()) > options.curvature;
}

/// Worse seams first, each kind by how much gap and angle have changed. A mismatch of curvature is
/// a share that is soon full, so it only decides between equals.
std::tuple<int, double, double> rank(const SeamChange& c, const CompareOptions& options) {
    const int kind = c.trend == SeamTrend::worse ? 0 : c.trend == SeamTrend::other ? 1 : 2;
    const double amount =
        std::max(std::abs(c.gap()) / options.gap, std::abs(c.angle()) / options.angle);
    return {kind, -amount, -std::abs(c.curvature())};
}

bool has_finding_of_face(const Inspection& inspection, const Check& finding) {
    return std::any_of(inspection.findings.begin(), inspection.findings.end(), [&](const Check& f) {
        return f.seam == no_index && f.code == finding.code && f.faces == finding.faces;
    });
}

/// Findings of `one`, divided by whether `other` has them too. It has one if a face of the same
/// name, or a partner of its seam, as the groups have them, has one of the same code. It also has
/// one if a partner of its seam has not changed.
struct DividedFindings {
    std::vector<Check> alone, shared;
};

using Side = std::vector<std::uint32_t> SeamGroup::*;

DividedFindings divided(const Inspection& one, Side side_one, const Inspection& other,
                        Side side_other, const std::vector<SeamGroup>& groups,
                        const std::vector<bool>& changed) {
    std::vector<std::set<std::string>> codes(other.seams.size()), known(one.seams.size());
    std::vector<bool> as_before(one.seams.size());
    for (std::size_t i = 0; i < one.seams.size(); ++i) as_before[i] = is_sliver(one.seams[i]);
    for (const Check& finding : other.findings)
        if (finding.seam != no_index) codes[finding.seam].insert(finding.code);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const int failed = first_failed(one, groups[g].*side_one);
        for (const std::uint32_t i : groups[g].*side_one) {
            as_before[i] = !changed[g] || first_failed(one.seams[i]) > failed;
            for (const std::uint32_t j : groups[g].*side_other)
                known[i].insert(codes[j].begin(), codes[j].end());
        }
    }
    DividedFindings found;
    for (const Check& finding : one.findings) {
        const bool shared =
            finding.seam == no_index
                ? has_finding_of_face(other, finding)
                : as_before[finding.seam] || known[finding.seam].contains(finding.code);
        (shared ? found.shared : found.alone).push_back(finding);
    }
    return found;
}

} // namespace

std::string_view name_of(SeamTrend trend) {
    constexpr std::array<std::string_view, 3> names{"better", "worse", "other"};
    return names[static_cast<std::size_t>(trend)];
}

double SeamChange::angle() const {
    return change(before.angle, after.angle);
}

double SeamChange::curvature() const {
    return change(before.curvature, after.curvature);
}

InspectionDifference compare_inspections(const Inspection& before, const Inspection& after,
                                         const CompareOptions& options) {
    SeamMatching matching = match_seams(before.seams, after.seams, options.place);
    InspectionDifference difference;
    std::vector<bool> changed; // a group
    for (const SeamGroup& group : matching.groups) {
        difference.matched += group.before.size();
        SeamChange c{group, state_of(before, group.before), state_of(after, group.after)};
        c.trend = trend_between(c.before, c.after);
        changed.push_back(is_change(c, options));
        if (changed.back()) difference.changed.push_back(std::move(c));
    }
    std::stable_sort(difference.changed.begin(), difference.changed.end(),
                     [&](const SeamChange& a, const SeamChange& b) {
                         return rank(a, options) < rank(b, options);
                     });
    difference.removed = std::move(matching.removed);
    difference.added = std::move(matching.added);
    DividedFindings late =
        divided(after, &SeamGroup::after, before, &SeamGroup::before, matching.groups, changed);
    DividedFindings early =
        divided(before, &SeamGroup::before, after, &SeamGroup::after, matching.groups, changed);
    difference.new_findings = std::move(late.alone);
    difference.same_findings = std::move(late.shared);
    difference.solved_findings = std::move(early.alone);
    return difference;
}

} // namespace keiko
