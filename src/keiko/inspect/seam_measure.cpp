#include "keiko/inspect/seam_measure.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/curvature_match.h"
#include "keiko/inspect/seam_chain.h"
#include "keiko/inspect/seam_extremes.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Extremes are wanted to this share of their limit: less than any verdict turns on.
constexpr double relative_tolerance = 1e-4;
/// Error of an evaluated point, as a share of its distance from the origin: some tens of
/// roundings of the Bernstein sums.
constexpr double relative_rounding = 1e-14;
/// degrees; error of an angle between two evaluated normals.
constexpr double angle_rounding = 1e-10;

/// The share of its limit that a curvature step uses up.
struct CurvatureJudge {
    CurvatureLimit limit;
    double flat_radius, flat_change;

    explicit CurvatureJudge(const CriteriaPreset& preset)
        : limit(preset.curvature.value_or(CurvatureLimit{})),
          flat_radius(preset.flat_radius),
          flat_change(preset.flat_curvature_change) {}

    bool flat(const SeamPoint& p) const {
        return std::max(std::abs(p.curvature_a), std::abs(p.curvature_b)) * flat_radius < 1;
    }
    double value(const SeamPoint& p) const {
        return flat(p) ? std::abs(p.curvature_a - p.curvature_b)
                       : curvature_mismatch(limit.formula, p.curvature_a, p.curvature_b);
    }
    double allowed(const SeamPoint& p) const { return flat(p) ? flat_change : limit.limit; }
};

/// The larger of two extremes of one quantity; the bound must cover what either could hide.
void keep_worse(std::optional<SeamExtreme>& kept, const std::optional<SeamExtreme>& other) {
    if (!other) return;
    if (!kept) {
        kept = other;
        return;
    }
    const double upper = std::max(kept->value + kept->bound, other->value + other->bound);
    if (other->value > kept->value) kept = other;
    kept->bound = upper - kept->value;
}

struct ChainExtremes {
    std::optional<SeamExtreme> gap, angle, negated_angle, curvature;
    double length = 0;
};

ChainExtremes extremes_of(const BoundaryCurves& curves, std::span<const Seam> seams,
                          const std::vector<std::uint32_t>& pieces, const CriteriaPreset& preset) {
    const CurvatureJudge curvature(preset);
    const std::vector<SeamQuestion> questions{
        {[](const SeamPoint& p) { return p.gap; }, relative_tolerance * preset.gap},
        {[](const SeamPoint& p) { return p.angle; }, relative_tolerance * preset.angle},
        {[](const SeamPoint& p) -> std::optional<double> {
             if (!p.angle) return std::nullopt;
             return -*p.angle;
         },
         preset.angle},
        {[&](const SeamPoint& p) -> std::optional<double> {
             if (!p.angle) return std::nullopt;
             return curvature.value(p) / curvature.allowed(p);
         },
         relative_tolerance * 10}};

    ChainExtremes all;
    const int least_cells = std::max(2, 8 / static_cast<int>(pieces.size()));
    for (const std::uint32_t piece : pieces) {
        const SeamProbe probe(curves, seams[piece]);
        const int cells = std::clamp(2 * probe.patch_count(), least_cells, 64);
        const auto found = seam_extremes(probe, questions, cells);
        keep_worse(all.gap, found[0]);
        keep_worse(all.angle, found[1]);
        keep_worse(all.negated_angle, found[2]);
        keep_worse(all.curvature, found[3]);
        all.length += probe.length();
    }
    return all;
}

Worst worst(const SeamExtreme& extreme, double rounding, double limit) {
    const double bound = extreme.bound + rounding;
    return {extreme.value, bound, limit, extreme.point.place, judge(extreme.value, bound, limit)};
}

CurvatureStep curvature_step(const SeamExtreme& extreme, const CriteriaPreset& preset) {
    const CurvatureJudge curvature(preset);
    const SeamPoint& p = extreme.point;
    CurvatureStep step{
        p.curvature_a, p.curvature_b, curvature.limit.formula, 0, curvature.flat(p), {}};
    step.mismatch = curvature_mismatch(step.formula, p.curvature_a, p.curvature_b);
    const double allowed = curvature.allowed(p);
    step.worst = {curvature.value(p), extreme.bound * allowed, allowed, p.place, Verdict::pass};
    if (preset.curvature) step.worst.verdict = judge(step.worst.value, step.worst.bound, allowed);
    return step;
}

std::string describe_side(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face) {
    std::string text = model.describe(model.faces[face]);
    if (model.instances.size() < 2) return text;
    const std::string& name = model.instances[instance].name;
    return text + " of " + (name.empty() ? "instance " + std::to_string(instance + 1) : name);
}

void take(MeasuredSeam& seam, const Worst& worst) {
    seam.verdict = std::max(seam.verdict, worst.verdict);
    seam.severity = std::max(seam.severity, worst.value / worst.limit);
}

class ChainMeasure {
public:
    ChainMeasure(const SurfaceModel& model, std::span<const Seam> seams,
                 const CriteriaPreset& preset)
        : model_(model), seams_(seams), preset_(preset) {}

    MeasuredSeam measure(const BoundaryCurves& curves, std::vector<std::uint32_t> pieces) const {
        const ChainExtremes found = extremes_of(curves, seams_, pieces, preset_);
        const Seam& first = seams_[pieces.front()];
        MeasuredSeam seam;
        seam.instance_a = first.a.instance, seam.face_a = first.a.face;
        seam.instance_b = first.b.instance, seam.face_b = first.b.face;
        seam.id_a = model_.faces[seam.face_a].id, seam.id_b = model_.faces[seam.face_b].id;
        seam.faces = describe_side(model_, seam.instance_a, seam.face_a) + " | " +
                     describe_side(model_, seam.instance_b, seam.face_b);
        seam.middle = middle_of(curves, pieces);
        seam.pieces = std::move(pieces);
        seam.length = found.length;
        seam.gap = worst(*found.gap, position_error(seam, found.gap->point.place), preset_.gap);
        take(seam, seam.gap);
        if (found.angle) judge_angle(seam, found);
        return seam;
    }

private:
    Vec3 middle_of(const BoundaryCurves& curves, const std::vector<std::uint32_t>& pieces) const {
        const BoundaryInterval& a = seams_[pieces[pieces.size() / 2]].a;
        // Of an even number of pieces the middle is where the later half begins.
        const double t = pieces.size() % 2 == 0 ? a.begin : (a.begin + a.end) / 2;
        return curves.curve(a).at(t).position;
    }

    double position_error(const MeasuredSeam& seam, const Vec3& place) const {
        return relative_rounding * place.length() + model_.faces[seam.face_a].approximated +
               model_.faces[seam.face_b].approximated;
    }

    void judge_angle(MeasuredSeam& seam, const ChainExtremes& found) const {
        seam.angle = worst(*found.angle, angle_rounding, preset_.angle);
        seam.smallest_angle = -found.negated_angle->value;
        seam.crease = seam.angle->value > preset_.feature_angle;
        if (seam.crease) return;
        take(seam, *seam.angle);
        if (seam.verdict != Verdict::pass || !found.curvature) return;
        seam.curvature = curvature_step(*found.curvature, preset_);
        if (preset_.curvature) take(seam, seam.curvature->worst);
    }

    const SurfaceModel& model_;
    std::span<const Seam> seams_;
    const CriteriaPreset& preset_;
};

} // namespace

std::vector<MeasuredSeam> measure_seams(const SurfaceModel& model, std::span<const Seam> seams,
                                        const CriteriaPreset& preset, double join, const Job& job) {
    const BoundaryCurves curves(model);
    std::vector<std::vector<std::uint32_t>> chains = seam_chains(curves, seams, join);
    std::vector<MeasuredSeam> measured(chains.size());
    const ChainMeasure measure(model, seams, preset);
    parallel_for(chains.size(), job, "measure", [&](std::size_t i) {
        measured[i] = measure.measure(curves, std::move(chains[i]));
    });
    return measured;
}

} // namespace keiko
