#include "keiko/inspect/seams/stretch_probes.h"

#include "keiko/inspect/seams/seam_chain.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace keiko {
namespace {

/// The two ends of a piece's side a; world, mm.
using Ends = std::array<Vec3, 2>;

/// One of the two ends of a piece.
struct End {
    std::size_t piece = 0;
    bool is_last = false; ///< else its first end
    double distance = HUGE_VAL;
};

const Vec3& place_of(const std::vector<Ends>& ends, const End& end) {
    return ends[end.piece][end.is_last ? 1 : 0];
}

/// mm from an end to the nearest one of the other pieces.
double distance_to_others(const std::vector<Ends>& ends, const End& end) {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (i != end.piece)
            for (const Vec3& other : ends[i])
                least = std::min(least, (other - place_of(ends, end)).length());
    return least;
}

/// The end at which the order starts: that of the most distant one, a first end if possible.
End start_of(const std::vector<Ends>& ends) {
    constexpr double clearly = 2; // ratio of distances
    End best;
    best.distance = same_vertex;
    for (const bool is_last : {false, true})
        for (std::size_t i = 0; i < ends.size(); ++i) {
            End end{i, is_last};
            end.distance = distance_to_others(ends, end);
            const double needed =
                is_last && !best.is_last ? clearly * best.distance : best.distance;
            if (end.distance > needed) best = end;
        }
    return best;
}

/// mm, of the chord of a piece.
double chord(const Ends& ends) {
    return (ends[1] - ends[0]).length();
}

/// The end nearest to a place among the pieces that are left. Of pieces that all have an end there
/// the shortest is first: it may be shorter than what is between ends of one vertex.
End nearest(const std::vector<Ends>& ends, const std::vector<bool>& is_taken, const Vec3& place) {
    End best;
    const auto order = [&](const End& end) {
        return std::tuple(std::max(end.distance, same_vertex), chord(ends[end.piece]),
                          end.distance);
    };
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (is_taken[i]) continue;
        for (const bool is_last : {false, true}) {
            End end{i, is_last};
            end.distance = (place_of(ends, end) - place).length();
            if (best.distance == HUGE_VAL || order(end) < order(best)) best = end;
        }
    }
    return best;
}

/// The stretches of the line to which a seam belongs.
std::span<const MeasuredSeam> line_of(std::span<const MeasuredSeam> seams, std::uint32_t index) {
    const std::uint32_t line = seams[index].line;
    std::size_t first = index, last = index;
    while (first > 0 && seams[first - 1].line == line) --first;
    while (last + 1 < seams.size() && seams[last + 1].line == line) ++last;
    return seams.subspan(first, last - first + 1);
}

/// A part, lengthened by those that it was cut from the same piece with. `extend` lengthens it by
/// another part at one of its ends, and returns whether it did.
template <class Part, class Extend>
Part lengthened(Part part, const std::vector<Part>& parts, const Extend& extend) {
    const auto by_any = [&] {
        return std::any_of(parts.begin(), parts.end(),
                           [&](const Part& other) { return extend(part, other); });
    };
    while (by_any()) {
    }
    return part;
}

bool on_one_curve(const BoundaryInterval& a, const BoundaryInterval& b) {
    return a.instance == b.instance && a.face == b.face && a.curve == b.curve;
}

/// The piece from which a part of a seam was cut.
Seam whole_of(const Seam& part, const std::vector<Seam>& parts) {
    return lengthened(part, parts, [](Seam& whole, const Seam& other) {
        if (!on_one_curve(whole.a, other.a) || !on_one_curve(whole.b, other.b)) return false;
        const bool after = other.a.begin == whole.a.end && other.a.end > whole.a.end;
        const bool before = other.a.end == whole.a.begin && other.a.begin < whole.a.begin;
        if (after) whole.a.end = other.a.end, whole.b.end = other.b.end;
        if (before) whole.a.begin = other.a.begin, whole.b.begin = other.b.begin;
        return after || before;
    });
}

/// The piece from which a part of a line inside a face was cut.
KnotPiece whole_of(const KnotPiece& part, const std::vector<KnotPiece>& parts) {
    return lengthened(part, parts, [](KnotPiece& whole, const KnotPiece& other) {
        if (whole.constant_u != other.constant_u || whole.at != other.at ||
            whole.low != other.low || whole.high != other.high)
            return false;
        const bool after = other.begin == whole.end && other.end > whole.end;
        const bool before = other.end == whole.begin && other.begin < whole.begin;
        if (after) whole.end = other.end;
        if (before) whole.begin = other.begin;
        return after || before;
    });
}

SeamProbe probe_of(const BoundaryCurves& curves, const Seam& part, const std::vector<Seam>& parts) {
    SeamPoint from, to;
    from.t = part.a.begin, from.s = part.b.begin;
    to.t = part.a.end, to.s = part.b.end;
    return SeamProbe(curves, whole_of(part, parts)).part(from, to);
}

} // namespace

std::vector<PlacedProbe> in_order(std::vector<SeamProbe> probes) {
    std::vector<Ends> ends;
    for (const SeamProbe& probe : probes)
        ends.push_back({probe.place(probe.begin()), probe.place(probe.end())});
    std::vector<bool> is_taken(probes.size(), false);
    std::vector<PlacedProbe> ordered;
    End next = start_of(ends);
    while (true) {
        is_taken[next.piece] = true;
        ordered.push_back({std::move(probes[next.piece]), next.is_last});
        if (ordered.size() == probes.size()) return ordered;
        next = nearest(ends, is_taken, ends[next.piece][next.is_last ? 0 : 1]);
    }
}

StretchProbes::StretchProbes(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
                             std::uint32_t index, std::span<const Seam> pieces) {
    const MeasuredSeam& seam = seams[index];
    std::vector<Seam> line_pieces;
    std::vector<KnotPiece> line_knots;
    for (const MeasuredSeam& other : line_of(seams, index)) {
        for (const std::uint32_t piece : other.pieces) line_pieces.push_back(pieces[piece]);
        line_knots.insert(line_knots.end(), other.knots.begin(), other.knots.end());
    }
    std::vector<SeamProbe> probes;
    for (const std::uint32_t piece : seam.pieces)
        probes.push_back(probe_of(borders.curves, pieces[piece], line_pieces));
    if (seam.internal) face_.emplace(borders.model, seam.face_a);
    for (const KnotPiece& piece : seam.knots)
        probes.push_back(knot_probe(borders, seam, piece, whole_of(piece, line_knots)));
    probes_ = in_order(std::move(probes));
}

SeamProbe StretchProbes::knot_probe(const ModelBorders& borders, const MeasuredSeam& seam,
                                    const KnotPiece& piece, const KnotPiece& whole) {
    const auto& left = p_curves_.emplace_back(whole.side(true));
    const auto& right = p_curves_.emplace_back(whole.side(false));
    const Affine& placed = borders.model.instances[seam.instance_a].transform;
    const auto at = [&](double x) {
        SeamPoint point;
        point.t = point.s = (x - whole.begin) / (whole.end - whole.begin);
        return point;
    };
    return face_->probe(whole, placed, left, right).part(at(piece.begin), at(piece.end));
}

} // namespace keiko
