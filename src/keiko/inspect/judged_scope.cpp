#include "keiko/inspect/judged_scope.h"

#include "keiko/inspect/regularity/face_draft.h"
#include "keiko/scene/stricter_limits.h"

#include <algorithm>

namespace keiko {
namespace {

bool is_beyond(const MeasuredValue& worst, double limit) {
    return judge(worst.value, worst.bound, limit) != Verdict::pass;
}

/// True if a stretch does not pass the limits of a preset, by what was measured of it.
bool is_beyond(const MeasuredSeam& seam, const CriteriaPreset& preset) {
    if (is_beyond(seam.gap, preset.gap)) return true;
    if (seam.angle && seam.is_angle_judged() && is_beyond(*seam.angle, preset.angle)) return true;
    if (seam.fading && is_beyond(*seam.fading, preset.fading)) return true;
    if (seam.curvature && preset.curvature) {
        const bool alias = preset.curvature->formula == CurvatureFormula::alias;
        MeasuredValue mismatch = seam.curvature->worst;
        mismatch.value = alias ? seam.curvature->alias : seam.curvature->catia;
        if (is_beyond(mismatch, preset.curvature->limit)) return true;
    }
    return seam.slope && preset.curvature_slope &&
           is_beyond(seam.slope->worst, *preset.curvature_slope);
}

/// Drafts were measured against the pull of the face's own limits, which is taken to be the same.
bool is_beyond(const MeasuredFace& face, const SurfaceLimits& limits) {
    if (limits.minimum_radius && face.radius &&
        face.radius->value - face.radius->bound < *limits.minimum_radius)
        return true;
    if (limits.draft && face.draft &&
        face.draft->value - face.draft->bound < limits.draft->angle - draft_tolerance)
        return true;
    return std::any_of(face.flaws.begin(), face.flaws.end(), [&](const Flaw& flaw) {
        return std::any_of(
            limits.waviness.begin(), limits.waviness.end(), [&](const WavinessLimit& limit) {
                return flaw.window == limit.window && is_beyond(flaw.depth, limit.depth);
            });
    });
}

/// Numbers the lines of stretches from 0 without a gap.
void renumber_lines(std::vector<MeasuredSeam>& seams) {
    std::uint32_t number = 0, before = 0;
    for (std::size_t i = 0; i < seams.size(); ++i) {
        if (i > 0 && seams[i].line != before) ++number;
        before = seams[i].line;
        seams[i].line = number;
    }
}

void count_seam(const FaceLimits& limits, const MeasuredSeam& seam, std::vector<ZoneFacts>& zones) {
    if (seam.scrap || seam.verdict != Verdict::pass || !is_beyond(seam, limits.preset())) return;
    const std::uint32_t a = limits.zone_of(seam.side_a()), b = limits.zone_of(seam.side_b());
    if (a != no_zone) ++zones[a].excused_seams;
    if (b != no_zone && b != a) ++zones[b].excused_seams;
}

/// Counts a face, its name and its zone.
void count_face(const FaceLimits& limits, const PlacedFace& face, const std::string& name,
                JudgedScope& scope) {
    const std::uint32_t zone = limits.zone_of(face);
    const bool in_scope = limits.in_scope(face);
    ++scope.all_faces;
    if (in_scope)
        ++scope.faces;
    else
        scope.outside.push_back(name);
    if (zone != no_zone)
        ++scope.zones[zone].faces;
    else if (in_scope)
        ++scope.zoneless;
}

/// Counts a face that passes by the limits of its zone alone.
void count_excused(const FaceLimits& limits, const MeasuredFace& face,
                   std::vector<ZoneFacts>& zones) {
    const std::uint32_t zone = limits.zone_of({face.instance, face.face});
    if (zone != no_zone && face.in_scope && face.verdict == Verdict::pass &&
        is_beyond(face, limits.preset().surface))
        ++zones[zone].excused_faces;
}

/// The zones and the words of the scope.
JudgedScope named_scope(const FaceLimits& limits) {
    JudgedScope scope;
    scope.selection = limits.scope();
    for (const Zone& zone : limits.preset().zones)
        scope.zones.push_back({.name = zone.name,
                               .selection = zone.selection.text(),
                               .looser = looser_limits(zone.limits, limits.preset())});
    return scope;
}

} // namespace

JudgedScope take_scope(const FaceLimits& limits, std::vector<MeasuredSeam>& seams,
                       std::vector<MeasuredFace>& faces) {
    JudgedScope scope = named_scope(limits);
    scope.all_seams = line_count(seams);
    std::erase_if(seams, [&](const MeasuredSeam& seam) {
        return !limits.in_scope(seam.side_a(), seam.side_b());
    });
    renumber_lines(seams);
    scope.seams = line_count(seams);
    for (const MeasuredSeam& seam : seams) count_seam(limits, seam, scope.zones);
    for (MeasuredFace& face : faces) {
        if (!face.in_scope) face.verdict = Verdict::pass;
        count_face(limits, {face.instance, face.face}, face.name, scope);
        count_excused(limits, face, scope.zones);
    }
    return scope;
}

JudgedScope scope_of_faces(const SurfaceModel& model, const FaceLimits& limits) {
    JudgedScope scope = named_scope(limits);
    for (const PlacedFace& face : placed_faces(model))
        if (model.faces[face.face].patch_count > 0)
            count_face(limits, face, placed_face_name(model, face.instance, face.face), scope);
    return scope;
}

} // namespace keiko
