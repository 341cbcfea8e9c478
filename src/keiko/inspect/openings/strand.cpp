#include "keiko/inspect/openings/strand.h"

#include "keiko/geometry/model/closest_point.h"

#include <algorithm>
#include <limits>

namespace keiko {

Strand::Strand(const FreeEdges& edges, FreeEnd start, FreeEnd back, double reach) : edges_(&edges) {
    for (;;) {
        parts_.push_back({start, length_});
        length_ += edges.all[start.edge].length();
        const FreeEnd far{start.edge, !start.last};
        if (far == back) closed_ = true;
        const auto next = edges.next_of(far);
        if (closed_ || !next || length_ >= reach) return;
        start = *next;
    }
}

std::uint32_t Strand::lowest_edge() const {
    std::uint32_t lowest = parts_.front().from.edge;
    for (const Part& part : parts_) lowest = std::min(lowest, part.from.edge);
    return lowest;
}

double Strand::deviation() const {
    double largest = 0;
    for (const Part& part : parts_)
        largest = std::max(largest, edges_->all[part.from.edge].deviation);
    return largest;
}

FreePlace Strand::at(double way) const {
    std::size_t i = parts_.size() - 1;
    while (i > 0 && parts_[i].begin > way) --i;
    const Part& part = parts_[i];
    const FreeEdge& edge = edges_->all[part.from.edge];
    const double along = way - part.begin;
    return edge.at(part.from.last ? edge.length() - along : along);
}

std::vector<FreePlace> Strand::places(double until) const {
    std::vector<FreePlace> corners;
    for (const Part& part : parts_) {
        const FreeEdge& edge = edges_->all[part.from.edge];
        const std::size_t count = edge.places.size();
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = part.from.last ? count - 1 - k : k;
            const double along = part.from.last ? edge.length() - edge.ways[i] : edge.ways[i];
            if (part.begin + along >= until) {
                corners.push_back(at(until));
                return corners;
            }
            corners.push_back(edge.places[i]);
        }
    }
    return corners;
}

FreePlace nearest_place(const std::vector<FreePlace>& line, const Vec3& p) {
    FreePlace best = line.front();
    double least = (best.position - p).length();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3 &from = line[i].position, &to = line[i + 1].position;
        const double share = nearest_on_segment(from, to, p);
        const Vec3 foot = from + (to - from) * share;
        if (const double distance = (foot - p).length(); distance < least) {
            least = distance, best = line[share < 0.5 ? i : i + 1];
            best.position = foot;
        }
    }
    return best;
}

} // namespace keiko
