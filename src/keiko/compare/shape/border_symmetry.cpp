#include "keiko/compare/shape/border_symmetry.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/inspect/openings/free_edges.h"

#include <algorithm>
#include <queue>

namespace keiko {
namespace {

/// A part of a free border between two corners of its polyline.
struct BorderCell {
    BoundaryInterval border;
    Box3 box; ///< of the curve
};

std::vector<BorderCell> cells_of(const FreeEdge& edge) {
    std::vector<BorderCell> cells;
    for (std::size_t i = 1; i < edge.places.size(); ++i) {
        const FreePlace &from = edge.places[i - 1], &to = edge.places[i];
        if (from.piece != to.piece || !(to.t > from.t)) continue;
        BoundaryInterval border = edge.pieces[from.piece];
        border.begin = from.t, border.end = to.t;
        Box3 box;
        box.extend(from.position), box.extend(to.position);
        cells.push_back({border, box.padded(edge.deviation)});
    }
    return cells;
}

/// Bound of how far a curve lies off the chord between two parameters, by its second derivatives at
/// three places: an estimate.
double sag(const SurfaceCurve& curve, double begin, double end) {
    double bend = 0;
    for (const double t : {begin, (begin + end) / 2, end})
        bend = std::max(bend, curve.at(t).second.length());
    return bend * (end - begin) * (end - begin) / 8;
}

/// A place of a border and the nearest place of its image.
struct BorderSample {
    double t = 0; ///< of the border's curve
    Vec3 position{0};
    double distance = 0;                    ///< mm, at most the reach
    const BoundaryInterval* foot = nullptr; ///< the nearest border; none within reach
    double foot_t = 0;                      ///< of its curve

    /// True if both feet lie on one curve.
    bool beside(const BorderSample& other) const {
        return foot && other.foot && foot->instance == other.foot->instance &&
               foot->face == other.foot->face && foot->curve == other.foot->curve;
    }
};

/// A part of a border and the largest distance that its ends allow between them.
struct BorderPart {
    BorderSample a, b;
    double most = 0; ///< mm

    bool operator<(const BorderPart& other) const { return most < other.most; }
};

class BorderSymmetry {
public:
    BorderSymmetry(const BoundaryCurves& curves, const std::vector<BorderCell>& targets,
                   const MirrorPlane& plane, const BorderSearch& search)
        : curves_(curves),
          targets_(targets),
          plane_(plane),
          search_(search),
          tree_(boxes_of(targets)) {}

    BorderSample sample(const SurfaceCurve& curve, double t) const {
        BorderSample found{t, curve.at(t).position, search_.reach, nullptr, 0};
        const Vec3 image = plane_.image(found.position);
        tree_.visit_near(image, search_.reach, [&](std::uint32_t i) {
            const BoundaryInterval& on = targets_[i].border;
            const ClosestPoint foot =
                closest_point(curves_.curve(on), image, (on.begin + on.end) / 2, on.begin, on.end);
            if (foot.distance < found.distance)
                found.distance = foot.distance, found.foot = &on, found.foot_t = foot.t;
            return found.distance;
        });
        return found;
    }

    /// Branch and bound over one cell; another cell has a place as far away as `known` mm.
    BorderDeviation farthest(const BoundaryInterval& cell, double known) const {
        const SurfaceCurve curve = curves_.curve(cell);
        BorderDeviation best{0, 0, Vec3(0), {cell.instance, cell.face}};
        const auto take = [&](const BorderSample& s) {
            if (s.distance >= best.distance) best.distance = s.distance, best.place = s.position;
        };
        std::priority_queue<BorderPart> parts;
        parts.push(part(curve, sample(curve, cell.begin), sample(curve, cell.end)));
        take(parts.top().a), take(parts.top().b);
        for (int cuts = 0; cuts < most_cuts; ++cuts) {
            const BorderPart top = parts.top();
            const double found = std::max(known, best.distance);
            if (top.most <= std::max(search_.limit / 10, found + search_.limit / 1000)) break;
            parts.pop();
            const BorderSample middle = sample(curve, (top.a.t + top.b.t) / 2);
            take(middle);
            parts.push(part(curve, top.a, middle));
            parts.push(part(curve, middle, top.b));
        }
        best.hidden = std::max(0.0, parts.top().most - best.distance);
        return best;
    }

private:
    /// Most cuts of one cell. What they cannot tell stays in the bound.
    static constexpr int most_cuts = 20000;

    static std::vector<Box3> boxes_of(const std::vector<BorderCell>& cells) {
        std::vector<Box3> boxes;
        for (const BorderCell& cell : cells) boxes.push_back(cell.box);
        return boxes;
    }

    /// A distance grows by no more than the way. Where both feet lie on one curve, the distance
    /// between its chord and that of the part is largest at an end.
    BorderPart part(const SurfaceCurve& curve, const BorderSample& a, const BorderSample& b) const {
        const double off = sag(curve, a.t, b.t);
        const double way = (b.position - a.position).length() + 4 * off;
        double most = (a.distance + b.distance + way) / 2;
        if (a.beside(b)) {
            const auto [begin, end] = std::minmax(a.foot_t, b.foot_t);
            most = std::min(most, std::max(a.distance, b.distance) + off +
                                      sag(curves_.curve(*a.foot), begin, end));
        }
        return {a, b, std::min(most, search_.reach)};
    }

    const BoundaryCurves& curves_;
    const std::vector<BorderCell>& targets_;
    MirrorPlane plane_;
    BorderSearch search_;
    BoxTree tree_;
};

} // namespace

std::optional<BorderDeviation> border_asymmetry(const SurfaceModel& model,
                                                std::span<const Seam> seams,
                                                const MirrorPlane& plane,
                                                const BorderSearch& search, const Job& job) {
    const BoundaryCurves curves(model);
    std::vector<BorderCell> targets, measured;
    for (const FreeEdge& edge : free_edges(curves, seams, 0, search.join, job).all) {
        const std::vector<BorderCell> cells = cells_of(edge);
        targets.insert(targets.end(), cells.begin(), cells.end());
        if (edge.length() > search.least)
            measured.insert(measured.end(), cells.begin(), cells.end());
    }
    if (measured.empty()) return std::nullopt;
    const BorderSymmetry symmetry(curves, targets, plane, search);
    std::vector<double> begins(measured.size());
    parallel_for(measured.size(), job, "", [&](std::size_t i) {
        const BoundaryInterval& cell = measured[i].border;
        begins[i] = symmetry.sample(curves.curve(cell), cell.begin).distance;
    });
    const double known = *std::max_element(begins.begin(), begins.end());
    std::vector<BorderDeviation> found(measured.size());
    parallel_for(measured.size(), job, "borders",
                 [&](std::size_t i) { found[i] = symmetry.farthest(measured[i].border, known); });
    BorderDeviation worst = found.front();
    double most = 0;
    for (const BorderDeviation& cell : found) {
        if (cell.distance > worst.distance) worst = cell;
        most = std::max(most, cell.distance + cell.hidden);
    }
    worst.hidden = most - worst.distance;
    return worst;
}

} // namespace keiko
