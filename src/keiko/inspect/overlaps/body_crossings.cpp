#include "keiko/inspect/overlaps/body_crossings.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/seam/border_approach.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/openings/bodies.h"
#include "keiko/intersect/traversal/tracer.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace keiko {
namespace {

/// Boxes of the control points of each body; world, mm.
std::vector<Box3> boxes_of(const SurfaceModel& model, const Bodies& bodies) {
    std::vector<Box3> boxes(bodies.count());
    for (std::size_t i = 0; i < bodies.count(); ++i)
        for (const PlacedFace& of : bodies.faces(i)) {
            const Face& face = model.faces[of.face];
            const Affine& placed = model.instances[of.instance].transform;
            for (std::uint32_t k = 0; k < face.patch_count; ++k)
                boxes[i].extend(PlacedPatch(model, face.first_patch + k, placed).box);
        }
    return boxes;
}

/// A chord of a border's polyline that may meet another body.
struct Candidate {
    std::uint32_t edge, chord; ///< into FreeEdges::all and FreeEdge::places
};

/// The part of a border beside a face that it crosses.
class Passage {
public:
    /// `way` in mm along the border to the place at which it meets the tangent plane of `hit`.
    Passage(const FreeEdge& border, double way, const Hit& hit, double join)
        : border_(border), hit_(hit), join_(join) {
        const double reach = join / 2 / std::sin(parallel_borders);
        const auto [below, above] = std::minmax({farthest(way, -reach), farthest(way, reach)});
        is_through_ = below < -join / 2 && above > join / 2;
    }

    bool is_through() const { return is_through_; }
    double length() const { return length_; }

private:
    /// The largest offset from the tangent plane on a way along the border; signed.
    double farthest(double from, double reach) {
        constexpr int steps = 16;
        double most = 0;
        for (int i = 1; i <= steps; ++i) {
            const double offset = (at(from + reach * i / steps) - hit_.position).dot(hit_.normal);
            if (std::abs(offset) > std::abs(most)) most = offset;
            if (std::abs(offset) <= join_) length_ += std::abs(reach) / steps;
        }
        return most;
    }

    Vec3 at(double way) const {
        const double all = border_.length();
        if (border_.closed) way = std::fmod(std::fmod(way, all) + all, all);
        return border_.at(std::clamp(way, 0.0, all)).position;
    }

    const FreeEdge& border_;
    const Hit& hit_;
    double join_;
    double length_ = 0; ///< mm within `join` of the tangent plane
    bool is_through_ = false;
};

class CrossingSearch {
public:
    CrossingSearch(const ModelBorders& borders, const Bodies& bodies, double join, const Job& job)
        : borders_(borders),
          bodies_(bodies),
          join_(join),
          job_(job),
          boxes_(boxes_of(borders.model, bodies)),
          tree_(boxes_) {}

    std::vector<Overlap> run() {
        if (!any_boxes_overlap()) return {};
        edges_ = free_edges(borders_.model, borders_.curves, {}, 0, join_, job_);
        const std::vector<Candidate> candidates = list_candidates();
        std::vector<Ray> rays;
        for (const Candidate& at : candidates) rays.push_back(ray_of(at));
        if (rays.empty()) return {};
        const auto hits = Tracer(borders_.model, {.join = join_}, job_).all(rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
            for (const Hit& hit : hits[i]) take(candidates[i], hit);
        std::vector<Overlap> crossings;
        for (const auto& [pair, crossing] : found_) crossings.push_back(crossing);
        return crossings;
    }

private:
    bool any_boxes_overlap() const {
        for (std::size_t i = 0; i < boxes_.size(); ++i)
            if (meets_another(boxes_[i], i)) return true;
        return false;
    }

    bool meets_another(const Box3& box, std::size_t body) const {
        const std::vector<std::uint32_t> met = tree_.overlapping(box);
        return std::any_of(met.begin(), met.end(), [&](std::uint32_t i) { return i != body; });
    }

    std::vector<Candidate> list_candidates() const {
        std::vector<Candidate> candidates;
        for (std::uint32_t e = 0; e < edges_.all.size(); ++e) {
            const std::vector<FreePlace>& places = edges_.all[e].places;
            const std::size_t body = bodies_.of(edges_.all[e].face());
            for (std::uint32_t k = 0; k + 1 < places.size(); ++k) {
                Box3 box;
                box.extend(places[k].position);
                box.extend(places[k + 1].position);
                if (meets_another(box, body)) candidates.push_back({e, k});
            }
        }
        return candidates;
    }

    Ray ray_of(const Candidate& at) const {
        const std::vector<FreePlace>& places = edges_.all[at.edge].places;
        Ray ray;
        ray.origin = places[at.chord].position;
        ray.direction = places[at.chord + 1].position - ray.origin;
        ray.t_max = 1;
        return ray;
    }

    void take(const Candidate& at, const Hit& hit) {
        const FreeEdge& border = edges_.all[at.edge];
        const PlacedFace on{hit.instance, hit.face};
        const std::size_t own = bodies_.of(border.face()), other = bodies_.of(on);
        if (own == other) return;
        const double from = border.ways[at.chord], to = border.ways[at.chord + 1];
        const Passage passage(border, from + hit.t * (to - from), hit, join_);
        if (!passage.is_through()) return;
        Overlap crossing{.kind = Overlap::Kind::crossing, .sides = {border.face(), on}};
        crossing.length = passage.length(), crossing.place = hit.position;
        const FreePlace& place = border.places[at.chord];
        const auto frame = borders_.curves.curve(border.pieces[place.piece]).frame(place.t);
        if (frame) {
            const double between = angle_between(frame->normal, hit.normal);
            crossing.angle = radians_to_degrees(std::min(between, std::acos(-1.0) - between));
        }
        const auto [known, is_new] = found_.try_emplace(std::minmax(own, other), crossing);
        if (!is_new && crossing.angle > known->second.angle) known->second = crossing;
    }

    const ModelBorders& borders_;
    const Bodies& bodies_;
    double join_;
    const Job& job_;
    std::vector<Box3> boxes_; ///< of each body
    BoxTree tree_;
    FreeEdges edges_;                                              ///< every border of every face
    std::map<std::pair<std::size_t, std::size_t>, Overlap> found_; ///< by two bodies
};

} // namespace

std::vector<Overlap> body_crossings(const ModelBorders& borders, std::span<const Seam> seams,
                                    double join, const Job& job) {
    const Bodies bodies(borders.model, seams);
    return CrossingSearch(borders, bodies, join, job).run();
}

} // namespace keiko
