#include "keiko/inspect/knot_lines.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/curvature_match.h"
#include "keiko/inspect/face_names.h"
#include "keiko/inspect/seam_line.h"
#include "keiko/patch/trim_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <tuple>

namespace keiko {
namespace {

/// A stretch of a line of constant u or v, in face parameters.
struct KnotPiece {
    bool constant_u = true;
    double at = 0, begin = 0, end = 0;

    auto order() const { return std::tuple(!constant_u, at, begin, end); }
    Vec2 point(double x) const { return constant_u ? Vec2(at, x) : Vec2(x, at); }
    std::array<Vec3, 2> points() const {
        const Vec2 a = point(begin), b = point(end);
        return {Vec3(a.x, a.y, 1), Vec3(b.x, b.y, 1)};
    }
};

/// The far sides of a patch, where another one may follow.
std::array<KnotPiece, 2> far_sides(const Patch& patch) {
    const ParameterMap &u = patch.map_u, &v = patch.map_v;
    return {KnotPiece{true, u.end, v.begin, v.end}, KnotPiece{false, v.end, u.begin, u.end}};
}

bool has_irregular_patch(const SurfaceModel& model, std::uint32_t face) {
    const auto by_face = [](const IrregularPatch& patch, std::uint32_t f) {
        return patch.face < f;
    };
    const auto found = std::lower_bound(model.irregular_patches.begin(),
                                        model.irregular_patches.end(), face, by_face);
    return found != model.irregular_patches.end() && found->face == face;
}

bool breaks_at(const SeamPoint& p) {
    constexpr double gap = 1e-4, angle = 1e-4, share = 1e-3, change = 2e-7;
    constexpr double unlimited_radius = HUGE_VAL; // mm: `change` tells apart what is flat
    if (p.gap > gap) return true;
    if (!p.angle) return false;
    return *p.angle > angle || (std::abs(p.curvature_a - p.curvature_b) > change &&
                                curvature_mismatch(CurvatureFormula::catia, p.curvature_a,
                                                   p.curvature_b, unlimited_radius) > share);
}

class FaceKnots {
public:
    FaceKnots(const SurfaceModel& model, std::uint32_t face)
        : model_(model), index_(face), grid_(model, model.faces[face]) {}

    std::vector<std::vector<MeasuredSeam>> measured(const CriteriaPreset& preset,
                                                    const StretchLimits& limits) const {
        std::vector<std::vector<MeasuredSeam>> seams;
        const std::vector<std::vector<KnotPiece>> lines = chained(kept(broken()));
        for (std::uint32_t i = 0; !lines.empty() && i < model_.instances.size(); ++i) {
            const Part& part = model_.parts[model_.instances[i].part];
            if (index_ - part.first_face >= part.face_count) continue;
            for (const auto& line : lines) seams.push_back(measure(i, line, preset, limits));
        }
        return seams;
    }

private:
    static SeamProbe probe(const SurfaceCurve& low, const SurfaceCurve& high) {
        return {low, {0, 1}, high, {0, 1}};
    }

    SurfaceCurve side(const Affine& placed, const std::array<Vec3, 2>& line, bool left) const {
        return {model_, grid_, placed, {line}, left};
    }

    std::vector<KnotPiece> broken() const;
    std::vector<KnotPiece> kept(const std::vector<KnotPiece>& pieces) const;
    static std::vector<std::vector<KnotPiece>> chained(std::vector<KnotPiece> pieces);
    std::vector<MeasuredSeam> measure(std::uint32_t instance, const std::vector<KnotPiece>& line,
                                      const CriteriaPreset& preset,
                                      const StretchLimits& limits) const;

    const SurfaceModel& model_;
    std::uint32_t index_;
    PatchGrid grid_;
};

std::vector<KnotPiece> FaceKnots::broken() const {
    std::vector<KnotPiece> pieces;
    const Box2 domain = grid_.domain();
    const Affine unmoved;
    for (const Patch& patch : model_.patches_of(model_.faces[index_]))
        for (const KnotPiece& piece : far_sides(patch)) {
            const bool at_end = piece.at >= (piece.constant_u ? domain.upper.x : domain.upper.y);
            if (at_end || !(piece.end > piece.begin)) continue;
            const std::array<Vec3, 2> line = piece.points();
            const SeamProbe across = probe(side(unmoved, line, true), side(unmoved, line, false));
            for (const double t : {0.11, 0.5, 0.87})
                if (breaks_at(across.at(t))) {
                    pieces.push_back(piece);
                    break;
                }
        }
    return pieces;
}

/// What the trims leave of the pieces: where they change sides between two of 16 places is found by
/// halving; what enters and leaves in between is too short to be told.
std::vector<KnotPiece> FaceKnots::kept(const std::vector<KnotPiece>& pieces) const {
    const Face& face = model_.faces[index_];
    if (face.loop_count == 0 || pieces.empty()) return pieces;
    constexpr int places = 16, halvings = 40;
    const TrimRegion region(model_, face);
    std::vector<KnotPiece> kept;
    for (const KnotPiece& piece : pieces) {
        const auto inside = [&](double x) { return region.contains(piece.point(x)); };
        const auto border = [&](double in, double out) {
            for (int i = 0; i < halvings; ++i) (inside((in + out) / 2) ? in : out) = (in + out) / 2;
            return in;
        };
        const auto at = [&](int i) {
            return piece.begin + (piece.end - piece.begin) * (i + 0.5) / places;
        };
        for (int i = 0; i < places; ++i) {
            if (!inside(at(i))) continue;
            const int first = i;
            while (i + 1 < places && inside(at(i + 1))) ++i;
            KnotPiece part = piece;
            part.begin = border(at(first), first == 0 ? piece.begin : at(first - 1));
            part.end = border(at(i), i + 1 == places ? piece.end : at(i + 1));
            kept.push_back(part);
        }
    }
    return kept;
}

std::vector<std::vector<KnotPiece>> FaceKnots::chained(std::vector<KnotPiece> pieces) {
    std::sort(pieces.begin(), pieces.end(),
              [](const KnotPiece& a, const KnotPiece& b) { return a.order() < b.order(); });
    std::vector<std::vector<KnotPiece>> lines;
    constexpr double touching = 1e-6; // share of a piece: trims end where knots do
    for (const KnotPiece& piece : pieces) {
        const KnotPiece* before = lines.empty() ? nullptr : &lines.back().back();
        const bool goes_on = before && before->constant_u == piece.constant_u &&
                             before->at == piece.at &&
                             piece.begin - before->end <= touching * (piece.end - piece.begin);
        if (!goes_on) lines.emplace_back();
        lines.back().push_back(piece);
    }
    return lines;
}

std::vector<MeasuredSeam> FaceKnots::measure(std::uint32_t instance,
                                             const std::vector<KnotPiece>& line,
                                             const CriteriaPreset& preset,
                                             const StretchLimits& limits) const {
    std::vector<std::array<Vec3, 2>> points;
    points.reserve(line.size());
    SeamLine seam{instance, index_, instance, index_, {}};
    const Affine& placed = model_.instances[instance].transform;
    for (const KnotPiece& piece : line) {
        points.push_back(piece.points());
        seam.probes.push_back(
            probe(side(placed, points.back(), true), side(placed, points.back(), false)));
    }
    char knot[48];
    std::snprintf(knot, sizeof knot, "%c = %.6g", line.front().constant_u ? 'u' : 'v',
                  line.front().at);
    std::vector<MeasuredSeam> measured;
    for (MeasuredStretch& stretch : measure_line(model_, seam, preset, limits)) {
        stretch.seam.faces = placed_face_name(model_, instance, index_) + ", inside at " + knot;
        stretch.seam.internal = true;
        measured.push_back(std::move(stretch.seam));
    }
    return measured;
}

} // namespace

std::vector<MeasuredSeam> measure_knot_lines(const SurfaceModel& model,
                                             const CriteriaPreset& preset, const Job& job) {
    const StretchLimits limits = stretch_limits(model, preset, 0);
    std::vector<std::vector<std::vector<MeasuredSeam>>> by_face(model.faces.size());
    parallel_for(model.faces.size(), job, "knots", [&](std::size_t f) {
        const Face& face = model.faces[f];
        const auto index = static_cast<std::uint32_t>(f);
        if (face.patch_count < 2 || face.approximated > 0 || has_irregular_patch(model, index))
            return;
        by_face[f] = FaceKnots(model, index).measured(preset, limits);
    });
    std::vector<MeasuredSeam> all;
    std::uint32_t number = 0;
    for (auto& lines : by_face)
        for (auto& line : lines) {
            for (MeasuredSeam& seam : line) seam.line = number;
            ++number;
            std::move(line.begin(), line.end(), std::back_inserter(all));
        }
    excuse_scraps(all, limits.negligible);
    return all;
}

} // namespace keiko
