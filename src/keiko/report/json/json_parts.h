#pragma once

#include "keiko/compare/alignment/alignment.h"
#include "keiko/inspect/seams/seam_profile.h"
#include "keiko/report/content/line_list.h"
#include "keiko/report/content/picture_outcome.h"
#include "keiko/report/markup/json_text.h"
#include "keiko/scene/camera.h"
#include "keiko/triage/triage.h"

namespace keiko {

/// projection, eye, target, up, vertical_fov, orthographic_height, width, height.
Json camera_json(const Camera& camera);
/// Inverse of camera_json. Throws Json::exception.
Camera camera_from(const Json& json);
/// Inverse of camera_json for a file of the user's. Throws Json::exception, and Error with the key
/// of a value that no camera can have.
Camera checked_camera_from(const Json& json);

/// view, problem, pixels, coverage_flips, face_flips, flips_within, layers [{layer, beyond,
/// largest, excess, root_mean_square, x, y, within}], width, height, before, after, difference.
Json picture_outcome_json(const PictureOutcome& picture);
/// Inverse of picture_outcome_json. Throws Json::exception.
PictureOutcome picture_outcome_from(const Json& json);

/// matrix, axis, angle, shift, residual, steps, converged.
Json alignment_json(const Alignment& alignment);

/// value, bound, limit, verdict, place.
Json measured_json(const MeasuredValue& value);

/// A finding, with the keys of inspection_json; `accepted` {who, why, when, until} if it is.
Json finding_json(const Check& finding);
/// The findings, then what is worth a look, each with its `number` from 1.
Json findings_json(const Inspection& inspection);
/// items and hidden, each [{mending, findings, seams, face, length, visible, width, weight, view,
/// mirrored}]; numbers from 1.
Json triage_json(const Triage& triage);
/// A profile with its stretch and samples, with the keys of keiko-profiles/1.
Json profile_json(const SeamProfile& profile, const Inspection& inspection);
/// Joints between panels, each with its sections.
Json joints_json(const std::vector<Joint>& joints);
/// The limits of joints that a preset has, and by what joints are sought.
Json joint_limits_json(const JointLimits& limits);
/// The accepted findings.
Json accepted_json(const Inspection& inspection);
/// A sentence for each acceptance that covers nothing.
Json acceptance_remarks_json(const Inspection& inspection);

/// The limits of seams and faces of a preset, or of a zone.
Json limits_json(const CriteriaPreset& limits);
/// name, source, caveat, and the limits of a preset without those of its zones.
Json preset_json(const CriteriaPreset& preset);
/// selection, faces, all_faces, seams, all_seams, out_of_scope, in_no_zone, zones [{name,
/// selection, faces, looser, excused_seams, excused_faces, limits}].
Json scope_json(const JudgedScope& scope, const CriteriaPreset& preset);

/// Lines in a report: rig, look, preset, verdict, counts and crossings, with the keys of lines_json
/// but without the curves.
Json line_verdicts_json(const LineList& list);

} // namespace keiko
