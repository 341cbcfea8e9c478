#include "keiko/inspect/inspection.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/border_checks.h"
#include "keiko/inspect/contact_checks.h"
#include "keiko/inspect/flaws/flaw_search.h"
#include "keiko/inspect/seams/seam_line.h"
#include "keiko/inspect/structure_checks.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace keiko {
namespace {

/// True if what does not pass as measured passes without what is accepted.
bool passes_as_accepted(Verdict measured, Verdict left) {
    return left == Verdict::pass && left < measured;
}

/// Counts a seam by the verdict that it has without what is accepted, `left`.
void count(const MeasuredSeam& seam, Verdict left, SeamCounts& counts) {
    if (seam.scrap) {
        ++counts.scraps;
        return;
    }
    if (passes_as_accepted(seam.verdict, left)) {
        ++counts.accepted;
        return;
    }
    switch (left) {
        case Verdict::fail:
            ++counts.fail;
            break;
        case Verdict::undecided:
            ++counts.undecided;
            break;
        case Verdict::pass:
            ++(seam.kind == SeamClass::crease    ? counts.creases
               : seam.kind == SeamClass::run_out ? counts.run_outs
                                                 : counts.pass);
            break;
    }
}

std::size_t& count_of(Verdict verdict, FaceCounts& counts) {
    return verdict == Verdict::fail        ? counts.fail
           : verdict == Verdict::undecided ? counts.undecided
                                           : counts.pass;
}

/// Change of the curvature, 1/mm. If one side bends the other way, the mismatch is 100 % for any
/// change.
double curvature_change(const MeasuredSeam& seam) {
    return seam.curvature ? std::abs(seam.curvature->curvature_a - seam.curvature->curvature_b) : 0;
}

/// Order of the findings of seams by severity; among equal shares of the limit, the larger change
/// of curvature is worse.
class Worse {
public:
    explicit Worse(const std::vector<MeasuredSeam>& seams) : seams_(seams) {}

    bool operator()(const Check& a, const Check& b) const {
        if (a.worst.verdict != b.worst.verdict) return a.worst.verdict > b.worst.verdict;
        const double x = share_of_limit(a.worst), y = share_of_limit(b.worst);
        return x != y ? x > y : change(a) > change(b);
    }

private:
    double change(const Check& check) const {
        const bool of_curvature = check.seam != no_index && check.quantity == "curvature";
        return of_curvature ? curvature_change(seams_[check.seam]) : 0;
    }

    const std::vector<MeasuredSeam>& seams_;
};

/// True if a place of a face, in world coordinates, lies in one of its irregular patches.
bool in_irregular_patch(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                        const Vec3& place) {
    const Affine& transform = model.instances[instance].transform;
    constexpr double slack = 1.01; // the border between patches belongs to both
    const auto by_face = [](const auto& a, const auto& b) { return a.face < b.face; };
    const auto [begin, end] =
        std::equal_range(model.irregular_patches.begin(), model.irregular_patches.end(),
                         IrregularPatch{face, Vec3(0), 0}, by_face);
    return std::any_of(begin, end, [&](const IrregularPatch& patch) {
        const Vec3 center = transform.point(patch.center);
        const Vec3 rim = transform.point(patch.center + Vec3(patch.radius, 0, 0));
        return (place - center).length() <= slack * (rim - center).length();
    });
}

void mark_irregular(const SurfaceModel& model, std::vector<MeasuredSeam>& seams) {
    for (MeasuredSeam& seam : seams) {
        const Vec3 place = worst_place(seam);
        seam.irregular = in_irregular_patch(model, seam.instance_a, seam.face_a, place) ||
                         in_irregular_patch(model, seam.instance_b, seam.face_b, place);
    }
}

/// The checks that satisfy the predicate, the worst first.
std::vector<Check> ranked(const Inspection& inspection, bool (Check::*predicate)() const) {
    std::vector<Check> found;
    std::copy_if(inspection.checks.begin(), inspection.checks.end(), std::back_inserter(found),
                 [predicate](const Check& check) { return (check.*predicate)(); });
    std::stable_sort(found.begin(), found.end(), Worse(inspection.seams));
    return found;
}

void take(Verdict verdict, std::vector<Check> checks, Inspection& result) {
    result.verdict = std::max(result.verdict, verdict);
    std::move(checks.begin(), checks.end(), std::back_inserter(result.checks));
}

PlacedFace placed(const MeasuredFace& face) {
    return {face.instance, face.face};
}

/// The different lists of limits by which dents and waves are searched on faces.
std::vector<std::vector<WavinessLimit>> flaw_limits(const Inspection& result) {
    std::vector<std::vector<WavinessLimit>> all;
    for (const MeasuredFace& face : result.faces) {
        const auto& limits = result.limits.of(placed(face)).flaw_limits();
        if (face.in_scope && !limits.empty() &&
            std::find(all.begin(), all.end(), limits) == all.end())
            all.push_back(limits);
    }
    return all;
}

/// For each face, whether dents and waves are searched on it: those in scope, and those beside
/// them, from which a dent may reach into the scope.
std::vector<bool> searched_faces(const Inspection& result) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> beside; // instance and face
    for (const MeasuredSeam& seam : result.seams)
        if (result.limits.in_scope(seam.side_a(), seam.side_b()))
            beside.insert({{seam.instance_a, seam.face_a}, {seam.instance_b, seam.face_b}});
    std::vector<bool> searched;
    for (const MeasuredFace& face : result.faces)
        searched.push_back(face.curvature &&
                           (face.in_scope || beside.contains({face.instance, face.face})));
    return searched;
}

/// Dents and waves, each by the limits of the face on which it is deepest.
void add_flaws(const SurfaceModel& model, Inspection& result, const Job& job) {
    const std::vector<bool> searched = searched_faces(result);
    for (const std::vector<WavinessLimit>& limits : flaw_limits(result)) {
        auto flaws = find_flaws(model, result.seams, result.pieces, searched, limits, job);
        for (std::size_t i = 0; i < flaws.size(); ++i) {
            MeasuredFace& face = result.faces[i];
            const CriteriaPreset& own = result.limits.of(placed(face));
            if (own.flaw_limits() != limits) continue;
            face.flaws = std::move(flaws[i]);
            if (own.surface.waviness.empty()) continue;
            for (const Flaw& flaw : face.flaws)
                face.verdict = std::max(face.verdict, flaw.depth.verdict);
        }
    }
}

void add_singular_places(const ModelBorders& borders, Inspection& result, const Job& job) {
    parallel_for(result.faces.size(), job, "", [&](std::size_t i) {
        MeasuredFace& face = result.faces[i];
        if (!face.curvature || !face.in_scope) return;
        const CriteriaPreset& preset = result.limits.of(placed(face));
        const double size = borders.sizes.of(face.instance, face.face);
        const double negligible = stretch_limits(size, size, preset, 0).negligible;
        face.singular =
            singular_places(borders.model, face.instance, face.face, {negligible, preset.angle});
        for (const SingularPlace& place : face.singular)
            face.verdict = std::max(face.verdict, verdict_of(place.kind));
    });
}

/// Checks at borders and of structure, of the faces that they count for.
std::vector<Check> checks_of_faces(const ModelBorders& borders, Inspection& result,
                                   const Job& job) {
    std::vector<Check> checks =
        checks_at_borders(borders, result.seams, result.pieces, result.limits, result.join, job);
    std::vector<Check> of_structure = structure_checks(borders, result.faces, result.limits, job);
    std::move(of_structure.begin(), of_structure.end(), std::back_inserter(checks));
    std::vector<Check> of_contacts = contact_checks(borders, result.faces, result.limits, job);
    std::move(of_contacts.begin(), of_contacts.end(), std::back_inserter(checks));
    for (const Check& check : checks)
        if (check.is_finding())
            result.faces[check.face].verdict =
                std::max(result.faces[check.face].verdict, check.worst.verdict);
    return checks;
}

/// Counts stretches and faces, and takes their checks and verdicts.
void judge_all(Inspection& result) {
    for (std::uint32_t i = 0; i < result.seams.size(); ++i) {
        const MeasuredSeam& seam = result.seams[i];
        count(seam, seam.verdict, result.counts);
        take(seam.verdict, checks_of(seam, limits_of(result, seam), result.join, i), result);
    }
    for (std::uint32_t i = 0; i < result.faces.size(); ++i) {
        const MeasuredFace& face = result.faces[i];
        if (!face.in_scope) continue;
        ++count_of(face.verdict, result.face_counts);
        take(face.verdict, checks_of(face, limits_of(result, face), i), result);
    }
}

/// Counts seams and faces anew by their checks. Returns the worst verdict that they and the
/// findings leave.
Verdict recount(Inspection& inspection) {
    std::vector<WorstChecks> seams(inspection.seams.size()), faces(inspection.faces.size());
    for (const Check& check : inspection.checks) {
        if (!check.is_finding() && !check.is_accepted()) continue;
        if (check.seam != no_index) seams[check.seam].add(check);
        if (check.face != no_index) faces[check.face].add(check);
    }
    Verdict worst = Verdict::pass;
    for (const Check& finding : inspection.findings) worst = std::max(worst, finding.worst.verdict);
    inspection.counts = {}, inspection.face_counts = {};
    for (std::uint32_t i = 0; i < seams.size(); ++i) {
        const MeasuredSeam& seam = inspection.seams[i];
        const Verdict left = seams[i].left_of(seam.verdict);
        count(seam, left, inspection.counts);
        if (passes_as_accepted(seam.verdict, left)) inspection.accepted_seams.push_back(i);
        worst = std::max(worst, left);
    }
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        if (!inspection.faces[i].in_scope) continue;
        const Verdict measured = inspection.faces[i].verdict, left = faces[i].left_of(measured);
        const bool accepted = passes_as_accepted(measured, left);
        ++(accepted ? inspection.face_counts.accepted : count_of(left, inspection.face_counts));
        if (accepted) inspection.accepted_faces.push_back(i);
        worst = std::max(worst, left);
    }
    return worst;
}

} // namespace

Inspection inspect(const SurfaceModel& model, const FaceLimits& limits, double join,
                   const Job& job) {
    Inspection result;
    result.preset = limits.preset(), result.limits = limits, result.join = join;
    if (!model.lost_faces.empty()) result.verdict = Verdict::undecided;
    const std::vector<Seam> paired = pair_seams(model, join, job);
    const ModelBorders borders(model);
    MeasuredSeams measured = measure_all_seams(borders, paired, limits, join, job);
    result.pieces = std::move(measured.pieces), result.seams = std::move(measured.seams);
    mark_irregular(model, result.seams);
    result.facts = model_facts(borders, paired, join, job);
    result.faces = measure_faces(model, limits, job);
    add_flaws(model, result, job);
    add_singular_places(borders, result, job);
    std::vector<Check> checks = checks_of_faces(borders, result, job);
    if (limits.has_zones_or_scope()) result.scope = take_scope(limits, result.seams, result.faces);
    result.facts.seams = line_count(result.seams);
    judge_all(result);
    take(Verdict::pass, std::move(checks), result);
    result.findings = ranked(result, &Check::is_finding);
    result.looks = ranked(result, &Check::is_worth_a_look);
    return result;
}

const CriteriaPreset& limits_of(const Inspection& inspection, const MeasuredSeam& seam) {
    return inspection.scope ? inspection.limits.between(seam.side_a(), seam.side_b())
                            : inspection.preset;
}

const CriteriaPreset& limits_of(const Inspection& inspection, const MeasuredFace& face) {
    return inspection.scope ? inspection.limits.of(placed(face)) : inspection.preset;
}

const Check& numbered_check(const Inspection& inspection, std::size_t number) {
    const std::size_t findings = inspection.findings.size();
    return number < findings ? inspection.findings[number] : inspection.looks.at(number - findings);
}

void add_check(Inspection& inspection, Check check) {
    if (check.severity == Check::Severity::judged) {
        MeasuredFace& face = inspection.faces.at(check.face);
        if (face.in_scope) {
            --count_of(face.verdict, inspection.face_counts);
            face.verdict = std::max(face.verdict, check.worst.verdict);
            ++count_of(face.verdict, inspection.face_counts);
        }
        inspection.verdict = std::max(inspection.verdict, check.worst.verdict);
    }
    const auto insert = [&](std::vector<Check>& ranked) {
        ranked.insert(
            std::upper_bound(ranked.begin(), ranked.end(), check, Worse(inspection.seams)), check);
    };
    if (check.is_finding()) insert(inspection.findings);
    if (check.is_worth_a_look()) insert(inspection.looks);
    inspection.checks.push_back(std::move(check));
}

void accept_findings(Inspection& inspection, const AcceptanceList& list) {
    AcceptanceList of_geometry{{}, list.today};
    for (const Acceptance& entry : list.entries)
        if (entry.view.empty()) of_geometry.entries.push_back(entry);
    inspection.acceptance_remarks = accept(inspection.checks, of_geometry, inspection.seams);
    inspection.accepted = ranked(inspection, &Check::is_accepted);
    if (inspection.accepted.empty()) return;
    inspection.findings = ranked(inspection, &Check::is_finding);
    inspection.verdict = recount(inspection);
    if (!inspection.facts.lost_faces.empty())
        inspection.verdict = std::max(inspection.verdict, Verdict::undecided);
}

bool is_accepted_seam(const Inspection& inspection, std::uint32_t seam) {
    const std::vector<std::uint32_t>& accepted = inspection.accepted_seams;
    return std::binary_search(accepted.begin(), accepted.end(), seam);
}

bool is_accepted_face(const Inspection& inspection, std::uint32_t face) {
    const std::vector<std::uint32_t>& accepted = inspection.accepted_faces;
    return std::binary_search(accepted.begin(), accepted.end(), face);
}

std::vector<std::uint32_t> worst_seams(const Inspection& inspection, std::size_t count) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < inspection.seams.size(); ++i) {
        const MeasuredSeam& seam = inspection.seams[i];
        if (!seam.scrap && !seam.is_passing_crease() && !is_accepted_seam(inspection, i))
            order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const MeasuredSeam &x = inspection.seams[a], &y = inspection.seams[b];
        if (x.severity != y.severity) return x.severity > y.severity;
        return curvature_change(x) > curvature_change(y);
    });
    order.resize(std::min(order.size(), count));
    return order;
}

Vec3 worst_place(const MeasuredSeam& seam) {
    const MeasuredValue* furthest = &seam.gap;
    const auto take = [&](const MeasuredValue& worst) {
        if (share_of_limit(worst) > share_of_limit(*furthest)) furthest = &worst;
    };
    if (seam.angle && seam.is_angle_judged()) take(*seam.angle);
    if (seam.curvature) take(seam.curvature->worst);
    if (seam.fading) take(*seam.fading);
    if (seam.slope && seam.slope->worst.verdict != Verdict::pass) take(seam.slope->worst);
    return furthest->place;
}

} // namespace keiko
