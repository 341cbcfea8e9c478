#include "keiko/inspect/seams/knot_lines.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/face_names.h"
#include "keiko/inspect/seams/bend_pieces.h"
#include "keiko/inspect/seams/face_sizes.h"
#include "keiko/inspect/seams/seam_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace keiko {
namespace {

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

class FaceKnots {
public:
    FaceKnots(const SurfaceModel& model, std::uint32_t face)
        : model_(model), index_(face), face_(model, face) {}

    std::vector<std::vector<MeasuredSeam>> measured(const CriteriaPreset& preset,
                                                    const FaceSizes& sizes) const {
        std::vector<std::vector<MeasuredSeam>> seams;
        const std::vector<KnotPiece> knots = broken();
        const std::vector<std::vector<KnotPiece>> breaks = chained(kept(knots));
        for (std::uint32_t i = 0; i < model_.instances.size(); ++i) {
            const Part& part = model_.parts[model_.instances[i].part];
            if (index_ - part.first_face >= part.face_count) continue;
            const double size = sizes.of(i, index_);
            const StretchLimits limits = stretch_limits(size, size, preset, 0);
            for (const auto& line : breaks) seams.push_back(measure(i, line, preset, limits));
            for (const auto& line : chained(kept(bends(knots, limits.negligible))))
                seams.push_back(measure(i, line, preset, limits));
        }
        return seams;
    }

private:
    std::vector<KnotPiece> broken() const;
    bool is_torn(const KnotPiece& knot) const;
    std::vector<KnotPiece> bends(const std::vector<KnotPiece>& knots, double window) const;
    std::vector<KnotPiece> kept(const std::vector<KnotPiece>& pieces) const;
    static std::vector<std::vector<KnotPiece>> chained(std::vector<KnotPiece> pieces);
    std::vector<MeasuredSeam> measure(std::uint32_t instance, const std::vector<KnotPiece>& line,
                                      const CriteriaPreset& preset,
                                      const StretchLimits& limits) const;

    const SurfaceModel& model_;
    std::uint32_t index_;
    KnottedFace face_;
};

std::vector<KnotPiece> FaceKnots::broken() const {
    std::vector<KnotPiece> pieces;
    const Box2 domain = face_.domain();
    const Affine unmoved;
    for (const Patch& patch : model_.patches_of(face_.face()))
        for (const KnotPiece& piece : far_sides(patch)) {
            const bool at_end = piece.at >= (piece.constant_u ? domain.upper.x : domain.upper.y);
            if (at_end || !(piece.end > piece.begin)) continue;
            const std::array<Vec3, 2> line = piece.side(true);
            const SeamProbe across = face_.probe(piece, unmoved, line, line);
            const auto breaks = [&](double t) { return breaks_at(across.at(t)); };
            if (std::any_of(tested_places.begin(), tested_places.end(), breaks))
                pieces.push_back(piece);
        }
    return pieces;
}

bool FaceKnots::is_torn(const KnotPiece& knot) const {
    constexpr double closed = 1e-4; // mm
    const Affine unmoved;
    const std::array<Vec3, 2> line = knot.side(true);
    const SeamProbe across = face_.probe(knot, unmoved, line, line);
    return std::any_of(tested_places.begin(), tested_places.end(),
                       [&](double t) { return across.at(t).gap > closed; });
}

/// The bends of the face, without those at which it is torn.
std::vector<KnotPiece> FaceKnots::bends(const std::vector<KnotPiece>& knots, double window) const {
    std::vector<KnotPiece> bends = bend_pieces(face_, window);
    if (bends.empty()) return bends;
    for (const KnotPiece& knot : knots)
        if (is_torn(knot))
            std::erase_if(bends, [&](const KnotPiece& bend) { return bend.meets(knot); });
    return bends;
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
        const auto inside = [&](double x) {
            return region.contains(piece.point(piece.low, x)) &&
                   (!piece.is_bend() || region.contains(piece.point(piece.high, x)));
        };
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

/// Bends of one line are found in patch after patch, each with a rounding of its own.
void align(std::vector<KnotPiece>& pieces) {
    const auto rises = [](const KnotPiece& a, const KnotPiece& b) { return a.order() < b.order(); };
    std::sort(pieces.begin(), pieces.end(), rises);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const KnotPiece& before = pieces[i - 1];
        KnotPiece& piece = pieces[i];
        if (piece.constant_u == before.constant_u && before.low < piece.at &&
            piece.at < before.high)
            piece.at = before.at;
    }
    std::sort(pieces.begin(), pieces.end(), rises);
}

std::vector<std::vector<KnotPiece>> FaceKnots::chained(std::vector<KnotPiece> pieces) {
    align(pieces);
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
    points.reserve(2 * line.size());
    SeamLine seam{instance, index_, instance, index_, {}};
    const Affine& placed = model_.instances[instance].transform;
    for (const KnotPiece& piece : line) {
        const auto& left = points.emplace_back(piece.side(true));
        const auto& right = points.emplace_back(piece.side(false));
        seam.probes.push_back(face_.probe(piece, placed, left, right));
    }
    char knot[48];
    std::snprintf(knot, sizeof knot, "%c = %.6g", line.front().constant_u ? 'u' : 'v',
                  line.front().at);
    CriteriaPreset judged = preset;
    if (!std::all_of(line.begin(), line.end(), [](const KnotPiece& p) { return p.has_limits; }))
        judged.curvature.reset(), judged.curvature_slope.reset();
    std::vector<MeasuredSeam> measured;
    for (MeasuredStretch& stretch : measure_line(model_, seam, judged, limits)) {
        stretch.seam.faces = placed_face_name(model_, instance, index_) + ", inside at " + knot;
        stretch.seam.internal = true;
        measured.push_back(std::move(stretch.seam));
    }
    return measured;
}

} // namespace

std::vector<MeasuredSeam> measure_knot_lines(const SurfaceModel& model,
                                             const CriteriaPreset& preset, const Job& job) {
    const FaceSizes sizes{BoundaryCurves(model)};
    std::vector<std::vector<std::vector<MeasuredSeam>>> by_face(model.faces.size());
    parallel_for(model.faces.size(), job, "knots", [&](std::size_t f) {
        const Face& face = model.faces[f];
        const auto index = static_cast<std::uint32_t>(f);
        if (face.approximated > 0 || has_irregular_patch(model, index)) return;
        by_face[f] = FaceKnots(model, index).measured(preset, sizes);
    });
    std::vector<MeasuredSeam> all;
    std::uint32_t number = 0;
    for (auto& lines : by_face)
        for (auto& line : lines) {
            for (MeasuredSeam& seam : line) seam.line = number;
            ++number;
            std::move(line.begin(), line.end(), std::back_inserter(all));
        }
    excuse_scraps(all);
    return all;
}

} // namespace keiko
