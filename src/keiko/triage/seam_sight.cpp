#include "keiko/triage/seam_sight.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/seams/stretch_probes.h"
#include "keiko/triage/crease_end.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm: length that a finding at a single place counts as.
constexpr double place_length = 10;

/// Degrees that a gap beyond its limit counts as: the limit of angles, times the share by which the
/// gap exceeds its own.
double angle_of_gap(double gap, const CriteriaPreset& limits) {
    return gap > limits.gap ? limits.angle * (gap / limits.gap - 1) : 0;
}

/// A place of a seam with what its class lets be a fault: the angle of a crease is its design. Nor
/// do angles count that pass all along a stretch.
SightPlace place_of(const SeamPoint& point, const BoundaryFrame& frame, double length,
                    const MeasuredSeam& seam) {
    // The side of the surface by which SeamProbe counts curvatures.
    const bool same_side = frame.tangent.cross(frame.inward).dot(frame.normal) > 0;
    SightPlace at;
    at.place = point.place, at.normal = same_side ? frame.normal : -frame.normal;
    at.along = frame.tangent, at.length = length, at.gap = point.gap;
    if (seam.kind != SeamClass::smooth || !point.angle) return at;
    if (seam.angle && seam.angle->verdict != Verdict::pass) at.angle = *point.angle;
    at.curvature_a = point.curvature_a, at.curvature_b = point.curvature_b;
    return at;
}

/// Leaves an angle, in degrees, to the places within `place_length` of an end, or to the nearest.
void keep_angle_at(const Vec3& end, double angle, std::vector<SightPlace>& places) {
    double reach = HUGE_VAL;
    for (const SightPlace& at : places) reach = std::min(reach, (at.place - end).length());
    reach = std::max(reach, place_length);
    for (SightPlace& at : places)
        at.angle = (at.place - end).length() <= reach ? std::min(at.angle, angle) : 0;
}

/// 1/mm: curvature of a seam's border along it over an interval, above 0 towards the normal.
double curvature_along(const SeamProbe& probe, double from, double to, const Vec3& normal) {
    const auto begin = probe.frame(from), end = probe.frame(to);
    const double length = probe.run((from + to) / 2).length() * (to - from);
    if (!begin || !end || !(length > 0)) return 0;
    const Vec3 along = (begin->tangent + end->tangent).normalized();
    const Vec3 turn = (end->normal - begin->normal) * std::copysign(1.0, normal.dot(begin->normal));
    return -turn.dot(along) / length;
}

/// Degrees by which the normals of both flanks of a flaw differ, if it has the form of a cosine.
double flank_angle(const Flaw& flaw) {
    const double turns = flaw.kind == Flaw::Kind::waves ? 2 : 1;
    return flaw.width > 0 ? turns * 180 * flaw.depth.value / flaw.width : 0;
}

/// The place of an opening, in the air, along which it is as wide all the way.
SightPlace place_of_opening(const Inspection& inspection, const Check& check,
                            const OuterSides& sides) {
    const MeasuredFace& face = inspection.faces.at(check.face);
    SightPlace at;
    at.place = check.worst.place, at.length = check.opening_length;
    at.gap = check.worst.value;
    at.gap_angle = angle_of_gap(at.gap, limits_of(inspection, face));
    at.outward = sides.outward_near({face.instance, face.face}, at.place);
    return at;
}

/// The place of a check of a face or of lines, without its normal.
SightPlace place_of(const Inspection& inspection, const Check& check) {
    SightPlace at;
    at.place = check.worst.place, at.length = place_length;
    if (check.code == "G-SU-NT" || check.code == "KEIKO-LINE-TURN") at.angle = check.worst.value;
    if (check.code == "KEIKO-LINE-JUMP") at.gap = check.worst.value;
    if (check.face == no_index) return at;
    for (const Flaw& flaw : inspection.faces[check.face].flaws)
        if (check.unit == "mm" && flaw.depth.place == check.worst.place)
            at.angle = flank_angle(flaw), at.length = flaw.width;
    return at;
}

} // namespace

FindingSights::FindingSights(const SurfaceModel& model, const Tracer& tracer,
                             const Inspection& inspection, std::optional<double> ground)
    : model_(model),
      inspection_(inspection),
      eyes_(tracer, ground),
      sides_(model, inspection, eyes_) {}

/// Places along a stretch, evenly in the parameters of its pieces.
std::vector<SightPlace> FindingSights::places_of(std::uint32_t stretch,
                                                 const ModelBorders& borders) const {
    constexpr double step = 5; // mm
    constexpr int least = 8, most = 64;
    const MeasuredSeam& seam = inspection_.seams[stretch];
    const CriteriaPreset& limits = limits_of(inspection_, seam);
    const auto crease_end = end_of_crease(inspection_, seam);
    const StretchProbes probes(borders, inspection_.seams, stretch, inspection_.pieces);
    const double count = std::clamp(seam.length / step, double(least), double(most));
    std::vector<SightPlace> places;
    for (const PlacedProbe& placed : probes.probes()) {
        const SeamProbe& probe = placed.probe;
        const double share = seam.length > 0 ? probe.length() / seam.length : 1;
        const int cells = std::max(2, static_cast<int>(std::lround(count * share)));
        const double cell = (probe.end() - probe.begin()) / cells;
        for (int i = 0; i < cells; ++i) {
            const double t = probe.begin() + (i + 0.5) * cell;
            const auto frame = probe.frame(t);
            if (!frame) continue;
            SightPlace at = place_of(probe.at(t), *frame, probe.run(t).length() * cell, seam);
            at.curvature_along = curvature_along(probe, t - cell / 2, t + cell / 2, at.normal);
            at.gap_angle = angle_of_gap(at.gap, limits);
            at.outward = sides_.outward(seam.side_a(), frame->normal);
            places.push_back(at);
        }
    }
    if (crease_end) keep_angle_at(*crease_end, seam.smallest_angle, places);
    return places;
}

std::vector<Sight> FindingSights::of_stretches(std::span<const std::uint32_t> stretches,
                                               const Job& job) const {
    std::vector<Sight> sights(inspection_.seams.size());
    if (stretches.empty()) return sights;
    const ModelBorders borders(model_);
    parallel_for(stretches.size(), job, "sights", [&](std::size_t i) {
        sights[stretches[i]] = eyes_.sight(places_of(stretches[i], borders));
    });
    return sights;
}

bool FindingSights::is_fault(const Check& check) const {
    if (!(check.opening_length > 0)) return true;
    const MeasuredFace& face = inspection_.faces.at(check.face);
    return sides_.hold({face.instance, face.face});
}

/// The normal is that of the surface where an eye sees the place; hidden places need none.
Sight FindingSights::of(const Check& check) const {
    if (check.opening_length > 0) {
        const SightPlace at = place_of_opening(inspection_, check, sides_);
        Sight sight = eyes_.sight(std::span(&at, 1));
        sight.spread = spread_share / 2 * check.opening_length;
        return sight;
    }
    SightPlace at = place_of(inspection_, check);
    if (const auto hit = eyes_.seen(at.place)) {
        at.normal = hit->normal;
        at.outward = sides_.outward({hit->instance, hit->face}, hit->normal);
    }
    return eyes_.sight(std::span(&at, 1));
}

} // namespace keiko
