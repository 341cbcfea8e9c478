#include "keiko/inspect/joint_checks.h"

#include "keiko/inspect/check_sentence.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/joints/find_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace keiko {
namespace {

/// A maximum found at a section, and what may be more extreme between sections.
MeasuredValue maximum(double found, double hidden, double error, double limit,
                      const JointSection& at) {
    MeasuredValue worst{found, hidden + error, limit, at.place()};
    worst.verdict = judge_maximum(found, hidden, error, limit);
    return worst;
}

/// The larger deviation of two extremes from a nominal size.
MeasuredValue deviation(const NominalSize& size, double low, const JointSection& at_low,
                        double high, const JointSection& at_high, double hidden) {
    const bool by_high = std::abs(high - size.nominal) >= std::abs(low - size.nominal);
    const JointSection& at = by_high ? at_high : at_low;
    const double found = std::abs((by_high ? high : low) - size.nominal);
    return maximum(found, hidden, at.bound, size.tolerance, at);
}

std::string from_to(double low, double high) {
    return short_number(low) + " to " + short_number(high) + " mm";
}

Check gap_check(const JointExtremes& e, const NominalSize& size) {
    const double low = e.narrowest.gap, high = e.widest.gap;
    const std::string what = "the deviation of the gap from " + short_number(size.nominal) + " mm";
    Check check = judged_check("KEIKO-JOINT-GAP", "mm",
                               deviation(size, low, e.narrowest, high, e.widest, e.hidden_gap),
                               {what.c_str(), " mm"});
    check.message += "; the gap is " + from_to(low, high);
    return check;
}

Check flush_check(const JointExtremes& e, const NominalSize& size) {
    const double low = e.deepest.flush, high = e.proudest.flush;
    const std::string what =
        "the deviation of the flush from " + short_number(size.nominal) + " mm";
    Check check = judged_check("KEIKO-JOINT-FLUSH", "mm",
                               deviation(size, low, e.deepest, high, e.proudest, e.hidden_flush),
                               {what.c_str(), " mm"});
    check.message += "; the second panel stands out by " + from_to(low, high);
    return check;
}

Check parallel_check(const JointExtremes& e, double limit) {
    const double found = e.widest.gap - e.narrowest.gap;
    const MeasuredValue worst =
        maximum(found, 2 * e.hidden_gap, e.widest.bound + e.narrowest.bound, limit, e.widest);
    Check check = judged_check("KEIKO-JOINT-PARALLEL", "mm", worst,
                               {"the difference of the largest and the smallest gap", " mm"});
    check.message += "; the gap is " + from_to(e.narrowest.gap, e.widest.gap);
    return check;
}

Check radius_check(const JointExtremes& e, double limit) {
    MeasuredValue worst{e.sharpest.least_radius(), e.hidden_radius + e.sharpest.bound, limit,
                        e.sharpest.place()};
    worst.at_least = true;
    worst.verdict = worst.value - worst.bound >= limit       ? Verdict::pass
                    : worst.value + e.sharpest.bound < limit ? Verdict::fail
                                                             : Verdict::undecided;
    return judged_check("KEIKO-JOINT-RADIUS", "mm", worst, {"the radius of an edge", " mm"});
}

/// Leaves no check passing of a joint that was not measured all along.
void add_unmeasured(const Joint& joint, Check& check) {
    if (!(joint.unmeasured > 0)) return;
    check.worst.verdict = std::max(check.worst.verdict, Verdict::undecided);
    const Vec3& at = joint.unmeasured_place;
    check.message += "; " + short_number(joint.unmeasured) + " mm of the joint, from (" +
                     short_number(at.x) + ", " + short_number(at.y) + ", " + short_number(at.z) +
                     ") on, cannot be measured";
}

Check unknown_check(const Joint& joint, std::string_view code, double limit) {
    Check check = named_check(code);
    check.unit = "mm";
    check.worst = {0, 0, limit, joint.stations.front().place, Verdict::undecided};
    check.message = "no section of the joint can be measured";
    return check;
}

} // namespace

std::vector<Check> checks_of(const Joint& joint, const JointLimits& limits) {
    const auto& e = joint.extremes;
    std::vector<Check> checks;
    const auto add = [&](const auto& limit, std::string_view code, double size, const auto& check) {
        if (!limit) return;
        checks.push_back(e ? check(*e, *limit) : unknown_check(joint, code, size));
        if (e) add_unmeasured(joint, checks.back());
    };
    const auto tolerance = [](const auto& size) { return size ? size->tolerance : 0; };
    add(limits.gap, "KEIKO-JOINT-GAP", tolerance(limits.gap), gap_check);
    add(limits.flush, "KEIKO-JOINT-FLUSH", tolerance(limits.flush), flush_check);
    add(limits.parallelism, "KEIKO-JOINT-PARALLEL", limits.parallelism.value_or(0), parallel_check);
    add(limits.radius, "KEIKO-JOINT-RADIUS", limits.radius.value_or(0), radius_check);
    return checks;
}

void check_joints(const SurfaceModel& model, Inspection& inspection, const Job& job) {
    const JointLimits& limits = inspection.preset.joint;
    inspection.joints = find_joints(model, inspection.pieces, limits, job);
    const std::vector<PlacedFace> faces = placed_faces(model);
    for (const Joint& joint : *inspection.joints)
        for (Check& check : checks_of(joint, limits)) {
            const auto at = std::find(faces.begin(), faces.end(), joint.faces[0]);
            check.face = static_cast<std::uint32_t>(at - faces.begin());
            check.faces = joint.names;
            add_check(inspection, std::move(check));
        }
}

} // namespace keiko
