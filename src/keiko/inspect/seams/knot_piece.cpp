#include "keiko/inspect/seams/knot_piece.h"

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/approximation_error.h"
#include "keiko/inspect/seams/curvature_match.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Degrees, and 1/mm: what breaks by less does so by the digits of a file.
constexpr double least_angle = 1e-4, least_change = 2e-7;

/// True if the face approximates one of the file too roughly to show a break of its own size.
bool hides_breaks(const KnottedFace& face) {
    const ApproximationError error = approximation_error(face.model(), face.index());
    return error.angle > least_angle || error.curvature > least_change;
}

/// A far side of a patch, where another one may follow.
struct FarSide {
    KnotPiece piece;
    int degree; ///< along it
};

std::array<FarSide, 2> far_sides(const SurfaceModel& model, std::uint32_t patch) {
    const ParameterMap &u = model.patches[patch].map_u, &v = model.patches[patch].map_v;
    const BezierPatchView points = model.patch(patch);
    return {FarSide{{true, u.end, v.begin, v.end}, points.degree_v},
            FarSide{{false, v.end, u.begin, u.end}, points.degree_u}};
}

/// The relation of both sides of a piece at its tested places.
std::vector<SeamPoint> places(const KnottedFace& face, const FarSide& side) {
    const Affine unmoved;
    const std::array<Vec3, 2> line = side.piece.side(true);
    const SeamProbe across = face.probe(side.piece, unmoved, line, line);
    std::vector<SeamPoint> points;
    for (const double t : isoline_places(4 * side.degree)) points.push_back(across.at(t));
    return points;
}

/// Share of a piece that is longer than rounding makes the distance of crossings at one place.
constexpr double sliver = 1e-12;

/// Parameters along a piece, from its begin to its end, between which each of its sides is either
/// in the material or out of it.
std::vector<double> cuts_of(const KnotPiece& piece, const TrimRegion& region) {
    std::vector<double> cuts{piece.begin, piece.end};
    for (const double line : {piece.low, piece.high})
        for (const double x : region.crossings(piece.constant_u ? 0 : 1, line))
            if (x > piece.begin && x < piece.end) cuts.push_back(x);
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

void add_trimmed(const KnotPiece& piece, const TrimRegion& region, std::vector<KnotPiece>& kept) {
    const auto inside = [&](double x) {
        return region.contains(piece.point(piece.low, x)) &&
               (!piece.is_bend() || region.contains(piece.point(piece.high, x)));
    };
    const double least = sliver * (piece.end - piece.begin);
    const std::vector<double> cuts = cuts_of(piece, region);
    const std::size_t first = kept.size();
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const double begin = cuts[i - 1], end = cuts[i];
        if (!(end - begin > least) || !inside((begin + end) / 2)) continue;
        if (kept.size() > first && begin - kept.back().end <= least) {
            kept.back().end = end;
            continue;
        }
        kept.push_back(piece);
        kept.back().begin = begin, kept.back().end = end;
    }
}

std::vector<KnotPiece> trimmed(const SurfaceModel& model, const Face& face,
                               const std::vector<KnotPiece>& pieces) {
    if (face.loop_count == 0 || pieces.empty()) return pieces;
    const TrimRegion region(model, face);
    std::vector<KnotPiece> kept;
    for (const KnotPiece& piece : pieces) add_trimmed(piece, region, kept);
    return kept;
}

/// Aligns the bends of one line, which are found in patch after patch, each with its own rounding.
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

} // namespace

std::vector<double> isoline_places(int count) {
    std::vector<double> places;
    for (int i = 0; i < count; ++i)
        places.push_back((1 - std::cos(std::numbers::pi * (i + 0.5) / count)) / 2);
    return places;
}

SurfaceDerivatives KnottedFace::derivatives(const Vec2& parameters, int order) const {
    const std::uint32_t index = grid_.locate(parameters, Vec2(0));
    const Patch& patch = model_.patches[index];
    const Vec2 uv(patch.map_u.to_patch(parameters.x), patch.map_v.to_patch(parameters.y));
    return evaluate(model_.patch(index), uv, order);
}

Vec3 KnottedFace::point(const Vec2& parameters) const {
    return derivatives(parameters, 0).position();
}

Vec3 KnottedFace::along(const Vec2& parameters, bool constant_u) const {
    const SurfaceDerivatives s = derivatives(parameters, 1);
    return constant_u ? s.dv() : s.du();
}

SeamProbe KnottedFace::probe(const KnotPiece& piece, const Affine& placed,
                             const std::array<Vec3, 2>& left,
                             const std::array<Vec3, 2>& right) const {
    const SurfaceCurve a = side(left, placed, true), b = side(right, placed, false);
    return piece.is_bend() ? SeamProbe::across_bend(a, b) : SeamProbe(a, {0, 1}, b, {0, 1});
}

bool breaks_at(const SeamPoint& p) {
    constexpr double gap = 1e-4, share = 1e-3;
    constexpr double unlimited_radius = HUGE_VAL; // mm: `least_change` identifies flat sides
    if (p.gap > gap) return true;
    if (!p.angle) return false;
    return *p.angle > least_angle || (std::abs(p.curvature_a - p.curvature_b) > least_change &&
                                      curvature_mismatch(CurvatureFormula::catia, p.curvature_a,
                                                         p.curvature_b, unlimited_radius) > share);
}

BrokenKnots broken_knots(const KnottedFace& face) {
    constexpr double closed = 1e-4; // mm
    const auto gapes = [](const SeamPoint& p) { return p.gap > closed; };
    const Box2 domain = face.domain();
    const bool rough = hides_breaks(face);
    BrokenKnots knots;
    for (std::uint32_t k = 0; k < face.face().patch_count; ++k)
        for (const FarSide& side : far_sides(face.model(), face.face().first_patch + k)) {
            const KnotPiece& piece = side.piece;
            const bool at_end = piece.at >= (piece.constant_u ? domain.upper.x : domain.upper.y);
            if (at_end || !(piece.end > piece.begin)) continue;
            const std::vector<SeamPoint> points = places(face, side);
            if (!rough && std::none_of(points.begin(), points.end(), breaks_at)) continue;
            knots.pieces.push_back(piece);
            if (std::any_of(points.begin(), points.end(), gapes)) knots.torn.push_back(piece);
        }
    return knots;
}

std::vector<std::vector<KnotPiece>> knot_chains(const SurfaceModel& model, const Face& face,
                                                const std::vector<KnotPiece>& untrimmed) {
    std::vector<KnotPiece> pieces = trimmed(model, face, untrimmed);
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

} // namespace keiko
