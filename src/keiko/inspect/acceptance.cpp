#include "keiko/inspect/acceptance.h"

#include "keiko/inspect/seams/course_distance.h"

#include <tuple>

namespace keiko {
namespace {

/// A finding that has grown by more than this is not the one that was accepted.
constexpr double largest_growth = 1.1;

/// True if neither the value nor the worst that it may be has grown. Comparisons fail for NaN.
bool has_kept(const MeasuredValue& now, double value, double bound) {
    if (!now.at_least)
        return now.value <= value * largest_growth &&
               now.value + now.bound <= (value + bound) * largest_growth;
    const double least = value - bound; // a draft angle may be negative
    return now.value >= (value > 0 ? value / largest_growth : value * largest_growth) &&
           (least <= 0 || now.value - now.bound >= least / largest_growth);
}

/// True if a finding is held to a closer limit than the one that was accepted, or to none.
bool is_held_closer(const Acceptance& entry, const MeasuredValue& now) {
    return !(now.at_least ? now.limit <= entry.limit : now.limit >= entry.limit);
}

bool has_grown(const Acceptance& entry, const Check& finding, std::span<const MeasuredSeam> seams) {
    if (finding.worst.verdict > entry.verdict) return true;
    if (entry.stretch && !(seams[finding.seam].length <= entry.stretch->length * largest_growth))
        return true;
    return !has_kept(finding.worst, entry.value, entry.bound);
}

/// True if a finding is of the kind of an entry and near its place.
bool is_at(const Acceptance& entry, const Check& finding, std::span<const MeasuredSeam> seams) {
    const bool of_seam = finding.seam != no_index;
    if (finding.code != entry.code || finding.formula != entry.formula ||
        finding.view != entry.view || of_seam != entry.stretch.has_value())
        return false;
    if (!((finding.worst.place - entry.place).length() <= entry.reach)) return false;
    return !of_seam ||
           distance_from_course(seams[finding.seam], entry.stretch->middle) <= acceptance_reach;
}

/// An entry and a finding near its place.
struct Candidate {
    std::size_t entry = 0, check = 0;
    bool other_faces = false;
    double distance = 0; ///< mm between their places

    bool operator<(const Candidate& other) const {
        return std::tie(other_faces, distance, entry, check) <
               std::tie(other.other_faces, other.distance, other.entry, other.check);
    }
};

std::vector<Candidate> candidates_of(std::span<const Check> checks, const AcceptanceList& list,
                                     std::span<const MeasuredSeam> seams) {
    std::vector<Candidate> candidates;
    for (std::size_t c = 0; c < checks.size(); ++c) {
        const Check& check = checks[c];
        if (!check.is_finding()) continue;
        for (std::size_t e = 0; e < list.entries.size(); ++e) {
            const Acceptance& entry = list.entries[e];
            if (!is_expired(entry.note, list.today) && is_at(entry, check, seams))
                candidates.push_back(
                    {e, c, check.faces != entry.faces, (check.worst.place - entry.place).length()});
        }
    }
    std::sort(candidates.begin(), candidates.end());
    return candidates;
}

AcceptanceRemark::Kind kind_of(const AcceptanceRemark& remark, const std::string& today,
                               std::span<const MeasuredSeam> seams) {
    using Kind = AcceptanceRemark::Kind;
    if (remark.finding)
        return has_grown(remark.entry, *remark.finding, seams) ? Kind::grown : Kind::held_closer;
    return is_expired(remark.entry.note, today) ? Kind::expired : Kind::unused;
}

} // namespace

double acceptance_reach_on(double stretch_length) {
    constexpr double share = 0.05;
    return std::max(acceptance_reach, share * stretch_length);
}

Acceptance acceptance_of(const Check& finding, std::span<const MeasuredSeam> seams,
                         AcceptanceNote note) {
    const MeasuredValue& worst = finding.worst;
    Acceptance entry{.code = finding.code,
                     .formula = finding.formula,
                     .view = finding.view,
                     .faces = finding.faces,
                     .unit = finding.unit,
                     .place = worst.place,
                     .reach = acceptance_reach,
                     .stretch = std::nullopt,
                     .value = worst.value,
                     .bound = worst.bound,
                     .limit = worst.limit,
                     .verdict = worst.verdict,
                     .note = std::move(note)};
    if (finding.seam == no_index) return entry;
    const MeasuredSeam& seam = seams[finding.seam];
    entry.stretch = Acceptance::Stretch{seam.middle, seam.length};
    entry.reach = acceptance_reach_on(seam.length);
    return entry;
}

bool accept_the_same(const Acceptance& a, const Acceptance& b) {
    return a.code == b.code && a.formula == b.formula && a.view == b.view && a.faces == b.faces &&
           a.place == b.place;
}

bool is_expired(const AcceptanceNote& note, const std::string& today) {
    return !note.until.empty() && note.until < today;
}

std::vector<AcceptanceRemark> accept(std::span<Check> checks, const AcceptanceList& list,
                                     std::span<const MeasuredSeam> seams) {
    std::vector<AcceptanceRemark> remarks(list.entries.size());
    std::vector<bool> used(list.entries.size()), met(checks.size());
    for (const Candidate& candidate : candidates_of(checks, list, seams)) {
        if (used[candidate.entry] || met[candidate.check]) continue;
        used[candidate.entry] = met[candidate.check] = true;
        const Acceptance& entry = list.entries[candidate.entry];
        Check& finding = checks[candidate.check];
        if (has_grown(entry, finding, seams) || is_held_closer(entry, finding.worst))
            remarks[candidate.entry].finding = finding;
        else
            finding.accepted = entry.note;
    }
    std::vector<AcceptanceRemark> told;
    for (std::size_t i = 0; i < remarks.size(); ++i) {
        AcceptanceRemark& remark = remarks[i];
        if (used[i] && !remark.finding) continue;
        remark.entry = list.entries[i];
        remark.kind = kind_of(remark, list.today, seams);
        told.push_back(std::move(remark));
    }
    return told;
}

} // namespace keiko
