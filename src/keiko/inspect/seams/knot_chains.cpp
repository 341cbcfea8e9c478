#include "keiko/inspect/seams/knot_chains.h"

#include "keiko/geometry/trim/trim_region.h"

#include <algorithm>

namespace keiko {
namespace {

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
