#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/acceptance.h"
#include "keiko/inspect/check.h"
#include "keiko/inspect/joints/joint.h"
#include "keiko/inspect/judged_scope.h"
#include "keiko/inspect/model_facts.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// Stretches of seams by verdict. A passing crease counts as a crease only, a passing run-out as a
/// run-out, and a scrap as a scrap. Findings that are accepted do not count; a stretch that would
/// pass without them counts as accepted.
struct SeamCounts {
    std::size_t fail = 0, undecided = 0, pass = 0;                   ///< number of each
    std::size_t creases = 0, run_outs = 0, scraps = 0, accepted = 0; ///< number of each

    bool operator==(const SeamCounts&) const = default;
};

/// Faces by their own verdict; accepted as in SeamCounts.
struct FaceCounts {
    std::size_t fail = 0, undecided = 0, pass = 0, accepted = 0; ///< number of each

    bool operator==(const FaceCounts&) const = default;
};

/// The geometry of a model judged by criteria.
struct Inspection {
    CriteriaPreset preset; ///< that it was judged by
    FaceLimits limits;     ///< those of the preset, and of its zones for this body
    /// The judged part, and the zones; nullopt if the preset has no zones and all is judged.
    std::optional<JudgedScope> scope;
    double join = 0.5;               ///< mm
    ModelFacts facts;                ///< summary of the model
    std::vector<Seam> pieces;        ///< as MeasuredSeams::pieces; MeasuredSeam::pieces points here
    std::vector<MeasuredSeam> seams; ///< stretch by stretch, with a judged side
    std::vector<MeasuredFace> faces; ///< each as placed
    std::vector<Check> checks;       ///< seam by seam, then face by face: all checks of the preset
    std::vector<Check> findings; ///< those that do not pass: failures before undecided, worst first
    std::vector<Check> looks;    ///< checks that deserve a look, in the same order
    std::vector<Check> accepted; ///< findings that are accepted, in the same order
    std::vector<AcceptanceRemark> acceptance_remarks; ///< on acceptances that cover nothing
    /// Stretches, and faces, that pass without what is accepted; rising indices.
    std::vector<std::uint32_t> accepted_seams, accepted_faces;
    std::optional<std::vector<Joint>> joints{}; ///< between panels; nullopt where not sought
    SeamCounts counts;                          ///< of `seams`
    FaceCounts face_counts;                     ///< of `faces` that are judged
    /// The worst verdict of all seams and faces, without what is accepted; never pass if faces were
    /// lost, since their seams are not judged.
    Verdict verdict = Verdict::pass;
};

/// Number of stages of inspect() in a job's progress.
constexpr int inspection_stages = 7;

/// Pairs, measures and judges every seam with a side in the scope, and every face that is in it.
/// Measures all faces. `join` in mm. Throws Cancelled.
Inspection inspect(const SurfaceModel& model, const FaceLimits& limits = {}, double join = 0.5,
                   const Job& job = {});

/// Limits that a stretch of an inspection is held to: those of the zones of its sides, or of the
/// preset.
const CriteriaPreset& limits_of(const Inspection& inspection, const MeasuredSeam& seam);
/// Limits that a face of an inspection is held to: those of its zone, or of the preset.
const CriteriaPreset& limits_of(const Inspection& inspection, const MeasuredFace& face);

/// A check by its number from 0, as reports count them: the findings, then the looks. Throws
/// std::out_of_range.
const Check& numbered_check(const Inspection& inspection, std::size_t number);

/// Adds a check of a face that was made apart from the inspection, as if it had been made with it.
void add_check(Inspection& inspection, Check check);

/// Takes the findings that the list covers out of the findings, the counts and the verdict. Entries
/// of lines are left to those who judge lines.
void accept_findings(Inspection& inspection, const AcceptanceList& list);

/// True if a stretch of a seam fails, and passes without what is accepted.
bool is_accepted_seam(const Inspection& inspection, std::uint32_t seam);
/// True if a face fails, and passes without what is accepted.
bool is_accepted_face(const Inspection& inspection, std::uint32_t face);

/// Indices of the `count` worst seams, by falling severity; neither scraps nor creases that pass,
/// nor accepted ones.
std::vector<std::uint32_t> worst_seams(const Inspection& inspection, std::size_t count);

/// Place of the worst value of the judged quantity that exceeds its limit most; world, mm.
Vec3 worst_place(const MeasuredSeam& seam);

} // namespace keiko
