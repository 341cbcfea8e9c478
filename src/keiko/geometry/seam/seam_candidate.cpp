#include "keiko/geometry/seam/seam_candidate.h"

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/math/bounds.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>

namespace keiko {
namespace {

/// Value at a parameter of the border, interpolated between the points of an offer; infinity beyond
/// its ends and beside points that do not count.
template <class Counts, class Value>
double between(const SeamOffer& offer, double x, const Counts& counts, const Value& value) {
    const auto& points = offer.candidate->stretch.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const FacingPoints &p = points[i], &q = points[i + 1];
        const double x0 = offer.parameter(p), x1 = offer.parameter(q);
        if (!(std::min(x0, x1) <= x && x <= std::max(x0, x1))) continue;
        if (!counts(p) || !counts(q)) continue;
        const double share = x1 != x0 ? (x - x0) / (x1 - x0) : 0;
        return value(p) + share * (value(q) - value(p));
    }
    return Box3::infinity;
}

/// Distance within which ends of pieces meet, as a share of the join distance and as a share of the
/// shorter piece's length: the ends of a tiny one would otherwise meet each other.
constexpr double meeting = 0.02, meeting_in_lengths = 0.1;

bool long_enough(double length, double widest, double join, bool fills_border) {
    return slender(length, widest) && (length >= join || fills_border);
}

/// True for a short contact of two faces whose borders touch as those of one vertex do. Borders
/// farther apart come as near beside any corner, and those of one face in the hooks of its trims.
bool touches(const SeamPiece& piece, double join) {
    constexpr double touching = 0.02, shortest = 0.2; // shares of the join distance
    return !piece.is_of_one_face() && slender(piece.length, piece.widest) &&
           piece.widest <= touching * join && piece.length >= shortest * join;
}

bool meet(const SeamPiece::Tip& x, const SeamPiece::Tip& y, double near) {
    return (x.position - y.position).length() <= near;
}

bool turns_corner(const SeamPiece::Tip& x, const SeamPiece::Tip& y) {
    return is_corner(x.onward, -y.onward);
}

/// Finds the ends of pieces that continue each other on both borders. The ends of piece k are 2 k
/// and 2 k + 1. Which border of a piece is its first says nothing about the next piece.
class PieceEnds {
public:
    PieceEnds(std::span<const SeamPiece> pieces, double join) : pieces_(pieces), join_(join) {}

    /// Calls `work(i, j)`, i < j, for the ends that continue each other.
    template <class Work>
    void for_meeting(const Work& work) const {
        std::vector<Box3> boxes(2 * pieces_.size());
        for (std::size_t i = 0; i < boxes.size(); ++i)
            for (const SeamPiece::Tip& tip : tips(i)) boxes[i].extend(tip.position);
        const BoxTree tree(boxes);
        for (std::uint32_t i = 0; i < boxes.size(); ++i)
            for (const std::uint32_t j : tree.overlapping(boxes[i].padded(meeting * join_)))
                if (j > i && (go_on(i, j, 0) || go_on(i, j, 1))) work(i, j);
    }

private:
    const std::array<SeamPiece::Tip, 2>& tips(std::size_t i) const {
        return pieces_[i / 2].ends[i % 2];
    }
    /// True if two ends continue each other. Border k of the first piece runs on into border k of
    /// the second, or into its other one if `crossed` is 1.
    bool go_on(std::size_t i, std::size_t j, std::size_t crossed) const {
        const SeamPiece &x = pieces_[i / 2], &y = pieces_[j / 2];
        const auto meet_on = [&](std::size_t side, double near) {
            return meet(tips(i)[side], tips(j)[side ^ crossed], near);
        };
        const auto turns_on = [&](std::size_t side) {
            return turns_corner(tips(i)[side], tips(j)[side ^ crossed]);
        };
        // Along two loops one begins where the other ends, whatever corners either has. Where teeth
        // of both are opposite each other, no place of one border faces the tips of the other.
        const bool in_order = (i % 2 != j % 2) == (crossed == 0 || x.same_direction);
        if (x.faces == y.faces && x.same_direction == y.same_direction && in_order &&
            (crossed == 0 || x.is_of_one_face()))
            return meet_on(0, meeting * join_) || meet_on(1, meeting * join_);
        const double near =
            std::min(meeting * join_, meeting_in_lengths * std::min(x.length, y.length));
        return meet_on(0, near) && meet_on(1, near) && !turns_on(0) && !turns_on(1);
    }

    std::span<const SeamPiece> pieces_;
    double join_;
};

/// Pieces too short to be seams that meet each other.
struct Run {
    double length = 0, widest = 0;
    int ends_at_seams = 0;

    void add(const SeamPiece& piece) {
        length += piece.length;
        widest = std::max(widest, piece.widest);
    }
    bool is_seam(double join) const {
        return ends_at_seams >= 2 || long_enough(length, widest, join, false);
    }
};

/// The scraps among some pieces, joined where they continue each other.
class JoinedScraps {
public:
    JoinedScraps(std::span<const SeamPiece> pieces, const std::vector<bool>& seams, double join)
        : pieces_(pieces),
          seams_(seams),
          join_(join),
          of_same_faces_(pieces.size()),
          over_faces_(pieces.size()),
          at_seam_(2 * pieces.size()) {
        PieceEnds(pieces, join).for_meeting([&](std::size_t i, std::size_t j) {
            add_meeting(i, j);
        });
        add_runs();
    }

    /// True if a scrap forms a seam with those that it is joined to.
    bool is_seam(std::size_t i) {
        return same_runs_[of_same_faces_.root(i)].is_seam(join_) ||
               over_runs_[over_faces_.root(i)].is_seam(join_);
    }

private:
    void add_meeting(std::size_t i, std::size_t j) {
        const std::size_t a = i / 2, b = j / 2;
        const bool scraps = !seams_[a] && !seams_[b];
        if (scraps) over_faces_.join(a, b);
        if (pieces_[a].faces != pieces_[b].faces) return;
        if (scraps) of_same_faces_.join(a, b);
        if (!seams_[a] && seams_[b]) at_seam_[i] = true;
        if (seams_[a] && !seams_[b]) at_seam_[j] = true;
    }

    void add_runs() {
        same_runs_.resize(pieces_.size()), over_runs_.resize(pieces_.size());
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            Run& run = same_runs_[of_same_faces_.root(i)];
            run.add(pieces_[i]);
            run.ends_at_seams += at_seam_[2 * i] + at_seam_[2 * i + 1];
            over_runs_[over_faces_.root(i)].add(pieces_[i]);
        }
    }

    std::span<const SeamPiece> pieces_;
    const std::vector<bool>& seams_;
    double join_;
    /// Sets of scraps of the same two faces, and over the borders between faces: a gap of many
    /// small faces.
    DisjointSets of_same_faces_, over_faces_;
    std::vector<Run> same_runs_, over_runs_; ///< by the roots of the sets
    std::vector<bool> at_seam_;              ///< an end of a scrap
};

} // namespace

double cost(const FacingPoints& p) {
    constexpr double overlap_penalty = 4;
    return p.overlap ? overlap_penalty * p.distance : p.distance;
}

double cost_at(const SeamOffer& offer, double x) {
    return between(
        offer, x, [](const FacingPoints&) { return true; }, cost);
}

double width_at(const SeamOffer& offer, double x) {
    return between(
        offer, x, [](const FacingPoints& p) { return p.overlap; },
        [](const FacingPoints& p) { return p.distance; });
}

std::vector<bool> seams_among(std::span<const SeamPiece> pieces, double join) {
    std::vector<bool> seams;
    for (const SeamPiece& p : pieces)
        seams.push_back(long_enough(p.length, p.widest, join, p.fills_border) || touches(p, join));
    JoinedScraps joined(pieces, seams, join);
    std::vector<bool> all = seams;
    for (std::size_t i = 0; i < pieces.size(); ++i) all[i] = seams[i] || joined.is_seam(i);
    return all;
}

} // namespace keiko
