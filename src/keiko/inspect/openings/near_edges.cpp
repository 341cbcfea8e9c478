#include "keiko/inspect/openings/near_edges.h"

#include "keiko/base/job.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/border_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Search structure over every chord of some free edges.
class Chords {
public:
    explicit Chords(const FreeEdges& edges) : edges_(edges), tree_(list()) {}

    /// The nearest place within `radius` mm on an edge of another face.
    std::optional<FreePlace> nearest(const FreePlace& from, double radius) const {
        std::optional<FreePlace> best;
        tree_.visit_near(from.position, radius, [&](std::uint32_t i) {
            const Chord& chord = chords_[i];
            const FreeEdge& edge = edges_.all[chord.edge];
            if (edge.face() == edges_.all[from.edge].face()) return radius;
            const FreePlace place = edge.at(way_of_nearest(edge, chord.place, from.position));
            const double distance = (place.position - from.position).length();
            if (distance <= radius) best = place, radius = distance;
            return radius;
        });
        return best;
    }

private:
    struct Chord {
        std::uint32_t edge, place;
    };

    std::vector<Box3> list() {
        std::vector<Box3> boxes;
        for (std::uint32_t e = 0; e < edges_.all.size(); ++e)
            for (std::uint32_t i = 0; i + 1 < edges_.all[e].places.size(); ++i) {
                chords_.push_back({e, i});
                boxes.emplace_back();
                boxes.back().extend(edges_.all[e].places[i].position);
                boxes.back().extend(edges_.all[e].places[i + 1].position);
            }
        return boxes;
    }

    static double way_of_nearest(const FreeEdge& edge, std::size_t i, const Vec3& p) {
        const double share =
            nearest_on_segment(edge.places[i].position, edge.places[i + 1].position, p);
        return edge.ways[i] + share * (edge.ways[i + 1] - edge.ways[i]);
    }

    const FreeEdges& edges_;
    std::vector<Chord> chords_;
    BoxTree tree_;
};

std::vector<NearEdges> stretches_of(const FreeEdge& edge, const Chords& chords, double join) {
    const double step = join / 4, least = 1.2 * join / std::sin(parallel_borders);
    std::vector<NearEdges> found;
    NearEdges current;
    const auto close = [&] {
        if (current.length > least) found.push_back(current);
        current = {};
    };
    double radius = join;
    for (double number = 0; number * step <= edge.length();) {
        check_stop();
        const FreePlace place = edge.at(number * step);
        const std::optional<FreePlace> other = chords.nearest(place, radius);
        const double distance = other ? (place.position - other->position).length() : radius;
        if (!other || distance > join) {
            close();
            // No edge is within `join` before that much of the way.
            number += std::max(std::floor((distance - join) / step), 1.0);
            radius = other ? std::max(distance, join) : 2 * radius;
            continue;
        }
        current.length += step, radius = join, number += 1;
        if (current.length > step && distance <= current.distance) continue;
        current.a = place, current.b = *other, current.distance = distance;
    }
    close();
    return found;
}

} // namespace

std::vector<NearEdges> near_edges(const FreeEdges& edges, double join, const Job& job) {
    const Chords chords(edges);
    std::vector<std::vector<NearEdges>> found(edges.all.size());
    parallel_for(edges.all.size(), job, "",
                 [&](std::size_t i) { found[i] = stretches_of(edges.all[i], chords, join); });
    std::vector<NearEdges> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

} // namespace keiko
