#include "keiko/geometry/seam/seam.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/seam/seam_candidate.h"
#include "keiko/math/interval_set.h"

#include <algorithm>

namespace keiko {
namespace {

/// mm: a curve shorter than this is a point in space, such as a pole.
constexpr double point_length = 1e-6;

class SeamPairing {
public:
    SeamPairing(const SurfaceModel& model, double join, const Job& job)
        : model_(model), join_(join), job_(job), curves_(model) {}

    std::vector<Seam> run() {
        make_borders();
        find_candidates();
        list_offers();
        return choose();
    }

private:
    void make_borders();
    void find_candidates();
    /// Pairs of borders within `join` that `wanted` accepts.
    template <class Wanted>
    std::vector<SeamCandidate> candidates(const BoxTree& tree, double join,
                                          const Wanted& wanted) const;
    std::vector<bool> covered_borders(const std::vector<SeamCandidate>& candidates) const;
    std::vector<std::vector<std::uint32_t>> partners_of(
        const std::vector<SeamCandidate>& candidates) const;
    std::vector<SeamCandidate> search(const BoxTree& tree) const;
    void list_offers();
    std::vector<Seam> choose() const;
    std::vector<Stretch> undominated(const SeamCandidate& candidate) const;
    bool dominated(const SeamCandidate& candidate, const FacingPoints& p) const;
    bool across_a_face(const SeamCandidate& candidate, const FacingPoints& p) const;
    bool is_narrow_face(const SeamCandidate& candidate) const;
    bool on_one_face(const SeamCandidate& candidate) const {
        const BoundaryInterval &a = intervals_[candidate.a], &b = intervals_[candidate.b];
        return a.instance == b.instance && a.face == b.face;
    }
    std::optional<std::uint32_t> shared_edge(const SeamCandidate& candidate) const;
    SeamPiece piece(const SeamCandidate& candidate, const Stretch& stretch) const;
    Seam seam(const SeamCandidate& candidate, const Stretch& stretch) const;

    const SurfaceModel& model_;
    double join_;
    const Job& job_;
    BoundaryCurves curves_;
    std::vector<BoundaryInterval> intervals_;
    std::vector<LoopLine> lines_; ///< a loop
    std::vector<Border> borders_;
    std::vector<SeamCandidate> candidates_;
    std::vector<std::vector<SeamOffer>> offers_; ///< a border
};

constexpr std::size_t borders_per_task = 16;

std::size_t task_count(std::size_t borders) {
    return (borders + borders_per_task - 1) / borders_per_task;
}

void SeamPairing::make_borders() {
    const auto loops = curves_.loops();
    for (const auto& loop : loops)
        for (const BoundaryInterval& i : loop) {
            intervals_.push_back(i);
            borders_.push_back({curves_.curve(i), {}});
        }
    parallel_for(task_count(borders_.size()), job_, "borders", [&](std::size_t task) {
        const std::size_t end = std::min(borders_.size(), (task + 1) * borders_per_task);
        for (std::size_t i = task * borders_per_task; i < end; ++i)
            borders_[i].polyline = make_polyline(borders_[i].curve, join_ / 10);
    });
    lines_.resize(loops.size());
    std::size_t border = 0;
    for (std::size_t i = 0; i < loops.size(); ++i)
        for (std::size_t end = border + loops[i].size(); border < end; ++border)
            borders_[border].append_to(lines_[i]);
}

template <class Wanted>
std::vector<SeamCandidate> SeamPairing::candidates(const BoxTree& tree, double join,
                                                   const Wanted& wanted) const {
    std::vector<std::vector<SeamCandidate>> found(task_count(borders_.size()));
    const auto search = [&](std::uint32_t a, std::vector<SeamCandidate>& into) {
        const CurvePolyline& polyline = borders_[a].polyline;
        if (!(polyline.length > point_length)) return;
        for (const std::uint32_t b : tree.overlapping(polyline.box().padded(join))) {
            if (b <= a || !(borders_[b].polyline.length > point_length) || !wanted(a, b)) continue;
            for (Stretch& stretch : stretches_alongside(borders_[a], borders_[b], join))
                into.push_back({a, b, std::move(stretch)});
        }
    };
    parallel_for(found.size(), job_, "seams", [&](std::size_t task) {
        const std::size_t end = std::min(borders_.size(), (task + 1) * borders_per_task);
        for (std::size_t a = task * borders_per_task; a < end; ++a)
            search(static_cast<std::uint32_t>(a), found[task]);
    });
    std::vector<SeamCandidate> all;
    for (auto& part : found) std::move(part.begin(), part.end(), std::back_inserter(all));
    return all;
}

/// Borders that have partners all along.
std::vector<bool> SeamPairing::covered_borders(const std::vector<SeamCandidate>& candidates) const {
    std::vector<std::vector<ParameterInterval>> parts(borders_.size());
    for (const SeamCandidate& c : candidates) {
        const FacingPoints &first = c.stretch.points.front(), &last = c.stretch.points.back();
        parts[c.a].push_back({first.t, last.t});
        parts[c.b].push_back({std::min(first.s, last.s), std::max(first.s, last.s)});
    }
    constexpr double almost_all = 0.99;
    std::vector<bool> covered;
    for (auto& intervals : parts)
        covered.push_back(IntervalSet(std::move(intervals)).measure() >= almost_all);
    return covered;
}

/// The partners of each border, by number, ascending.
std::vector<std::vector<std::uint32_t>> SeamPairing::partners_of(
    const std::vector<SeamCandidate>& candidates) const {
    std::vector<std::vector<std::uint32_t>> partners(borders_.size());
    for (const SeamCandidate& c : candidates)
        partners[c.a].push_back(c.b), partners[c.b].push_back(c.a);
    for (auto& of_border : partners) std::sort(of_border.begin(), of_border.end());
    return partners;
}

/// True if two ascending ranges share a number.
bool share_one(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    return std::any_of(a.begin(), a.end(),
                       [&](std::uint32_t x) { return std::binary_search(b.begin(), b.end(), x); });
}

/// Searches near by first, where a sewn model finds everything. Only borders that are still open
/// are searched as far as the join distance. Two that are covered by one border between them, as
/// that of a rib, may be twice as far apart as either is from it.
std::vector<SeamCandidate> SeamPairing::search(const BoxTree& tree) const {
    constexpr double close_by = 0.02;
    std::vector<SeamCandidate> found =
        candidates(tree, close_by * join_, [](std::uint32_t, std::uint32_t) { return true; });
    const std::vector<bool> covered = covered_borders(found);
    const auto partners = partners_of(found);
    const auto open = [&](std::uint32_t a, std::uint32_t b) { return !covered[a] || !covered[b]; };
    const auto flank = [&](std::uint32_t a, std::uint32_t b) {
        return !open(a, b) && share_one(partners[a], partners[b]);
    };
    std::erase_if(found, [&](const SeamCandidate& c) { return open(c.a, c.b) || flank(c.a, c.b); });
    for (auto& more :
         {candidates(tree, join_, open), candidates(tree, 2 * close_by * join_, flank)})
        found.insert(found.end(), more.begin(), more.end());
    return found;
}

void SeamPairing::find_candidates() {
    std::vector<Box3> boxes;
    for (const Border& border : borders_) boxes.push_back(border.polyline.box());
    candidates_ = search(BoxTree(std::move(boxes)));
    for (SeamCandidate& candidate : candidates_) {
        candidate.is_narrow = is_narrow_face(candidate);
        const SeamPiece whole = piece(candidate, candidate.stretch);
        candidate.is_slender = slender(whole.length, whole.widest);
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const SeamCandidate& x, const SeamCandidate& y) {
                         return std::pair(x.a, x.b) < std::pair(y.a, y.b);
                     });
}

void SeamPairing::list_offers() {
    offers_.resize(borders_.size());
    for (const SeamCandidate& candidate : candidates_) {
        offers_[candidate.a].push_back({&candidate, true});
        offers_[candidate.b].push_back({&candidate, false});
    }
}

/// True if both borders are of one face that is narrow between them. It is longer from one to the
/// other of a face that is closed, whose ends may overlap.
bool SeamPairing::is_narrow_face(const SeamCandidate& candidate) const {
    constexpr double longest = 2; // more than around half a circle
    if (!on_one_face(candidate)) return false;
    const FacingPoints& p = candidate.stretch.points[candidate.stretch.points.size() / 2];
    return curves_.way_over_face(intervals_[candidate.a], p.t, intervals_[candidate.b], p.s) <=
           longest * p.distance;
}

/// True if the connection between the borders crosses the whole width of one of the faces. The
/// border beyond its other border is that face's neighbour.
bool SeamPairing::across_a_face(const SeamCandidate& candidate, const FacingPoints& p) const {
    const double reach = p.distance + indistinct_share * join_;
    const auto narrow = [&](const std::vector<SeamOffer>& offers, double x) {
        return std::any_of(offers.begin(), offers.end(), [&](const SeamOffer& offer) {
            return offer.candidate->is_narrow && width_at(offer, x) <= reach;
        });
    };
    return p.overlap && (narrow(offers_[candidate.a], p.t) || narrow(offers_[candidate.b], p.s));
}

/// True if the borders belong to other partners here: both have a clearly nearer one, or a whole
/// face lies between them.
bool SeamPairing::dominated(const SeamCandidate& candidate, const FacingPoints& p) const {
    const double slack = indistinct_share * join_;
    if (p.distance <= slack) return false;
    if (candidate.is_narrow && p.overlap) return true;
    if (across_a_face(candidate, p)) return true;

    const auto best = [&](const std::vector<SeamOffer>& offers, double x) {
        double least = Box3::infinity;
        for (const SeamOffer& offer : offers)
            if (offer.candidate != &candidate && offer.candidate->is_slender)
                least = std::min(least, cost_at(offer, x));
        return least;
    };
    // A border just in the middle between two is not clearly nearer to either.
    constexpr double clearly = 0.5 * (1 - 1e-6);
    const double bar = clearly * cost(p);
    return best(offers_[candidate.a], p.t) < bar && best(offers_[candidate.b], p.s) < bar;
}

std::vector<Stretch> SeamPairing::undominated(const SeamCandidate& candidate) const {
    std::vector<Stretch> kept;
    Stretch current;
    const auto close = [&] {
        if (current.points.size() > 1) kept.push_back(std::move(current));
        current = {};
    };
    for (const FacingPoints& p : candidate.stretch.points)
        dominated(candidate, p) ? close() : current.points.push_back(p);
    close();
    return kept;
}

SeamPiece SeamPairing::piece(const SeamCandidate& candidate, const Stretch& stretch) const {
    const BoundaryInterval &a = intervals_[candidate.a], &b = intervals_[candidate.b];
    const Border &border_a = borders_[candidate.a], &border_b = borders_[candidate.b];
    std::vector<std::array<Vec3, 2>> way;
    for (const FacingPoints& p : stretch.points)
        way.push_back({border_a.curve.at(p.t).position, border_b.curve.at(p.s).position});
    SeamPiece result{.faces = {a.instance, a.face, b.instance, b.face}};
    for (std::size_t side = 0; side < 2; ++side) {
        const auto tip = [&](const auto& end, const auto& before) {
            return SeamPiece::Tip{end[side], end[side] - before[side]};
        };
        result.ends[0][side] = tip(way[0], way[1]);
        result.ends[1][side] = tip(way.back(), way[way.size() - 2]);
    }
    std::array<double, 2> lengths{};
    for (std::size_t i = 0; i < way.size(); ++i) {
        for (std::size_t side = 0; i > 0 && side < 2; ++side)
            lengths[side] += (way[i][side] - way[i - 1][side]).length();
        result.widest = std::max(result.widest, stretch.points[i].distance);
    }
    result.length = std::min(lengths[0], lengths[1]);
    result.same_direction = stretch.points.front().s < stretch.points.back().s;
    constexpr double filled = 0.9;
    const double shorter = std::min(border_a.polyline.length, border_b.polyline.length);
    const bool of_two = !on_one_face(candidate) || shared_edge(candidate);
    result.fills_border = of_two && result.length >= filled * shorter;
    return result;
}

/// The edge of the file to which both borders belong; nullopt if there is none.
std::optional<std::uint32_t> SeamPairing::shared_edge(const SeamCandidate& candidate) const {
    const BoundaryInterval &a = intervals_[candidate.a], &b = intervals_[candidate.b];
    if (a.curve >= natural_side || b.curve >= natural_side) return std::nullopt;
    const std::uint32_t edge = model_.trim_curves[a.curve].edge;
    if (edge == no_index || edge != model_.trim_curves[b.curve].edge) return std::nullopt;
    return edge;
}

Seam SeamPairing::seam(const SeamCandidate& candidate, const Stretch& stretch) const {
    const FacingPoints &first = stretch.points.front(), &last = stretch.points.back();
    Seam result{intervals_[candidate.a], intervals_[candidate.b], shared_edge(candidate)};
    result.a.begin = first.t, result.a.end = last.t;
    result.b.begin = first.s, result.b.end = last.s;
    return result;
}

std::vector<Seam> SeamPairing::choose() const {
    std::vector<SeamPiece> pieces;
    std::vector<Seam> all, seams;
    for (const SeamCandidate& candidate : candidates_)
        for (const Stretch& stretch : undominated(candidate)) {
            check_stop();
            const SeamPiece found = piece(candidate, stretch);
            if (!(found.length > point_length)) continue;
            pieces.push_back(found);
            all.push_back(seam(candidate, stretch));
        }
    const std::vector<bool> kept = seams_among(pieces, join_);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (kept[i]) seams.push_back(all[i]);
    return seams;
}

} // namespace

std::vector<Seam> pair_seams(const SurfaceModel& model, double join, const Job& job) {
    return SeamPairing(model, join, job).run();
}

} // namespace keiko
