#include "keiko/inspect/overlaps/edge_samples.h"

#include <algorithm>
#include <cmath>

namespace keiko {

FreeEdgeSamples::FreeEdgeSamples(const FreeEdges& edges, double step)
    : edges_(edges), tree_(list_chords(step)) {}

std::vector<Box3> FreeEdgeSamples::list_chords(double step) {
    std::vector<Box3> boxes;
    std::uint32_t next = 0;
    for (std::uint32_t e = 0; e < edges_.all.size(); ++e) {
        const FreeEdge& edge = edges_.all[e];
        for (std::uint32_t i = 0; i + 1 < edge.places.size(); ++i) {
            const double steps = std::ceil((edge.ways[i + 1] - edge.ways[i]) / step);
            chords_.push_back({e, i, next, std::max(1U, static_cast<std::uint32_t>(steps)),
                               edge.places[i].position, edge.places[i + 1].position});
            next += chords_.back().steps;
            Box3& box = boxes.emplace_back();
            box.extend(chords_.back().from);
            box.extend(chords_.back().to);
        }
        ++next; // the end of the edge
    }
    return boxes;
}

const FreeEdgeSamples::Chord& FreeEdgeSamples::chord_of(std::uint32_t sample) const {
    const auto beyond =
        std::upper_bound(chords_.begin(), chords_.end(), sample,
                         [](std::uint32_t number, const Chord& c) { return number < c.first; });
    return *(beyond - 1);
}

double FreeEdgeSamples::way(std::uint32_t sample) const {
    const Chord& chord = chord_of(sample);
    const std::vector<double>& ways = edges_.all[chord.edge].ways;
    const double share = double(sample - chord.first) / chord.steps;
    return ways[chord.place] + share * (ways[chord.place + 1] - ways[chord.place]);
}

FreePlace FreeEdgeSamples::place(std::uint32_t sample) const {
    FreePlace place = edges_.all[edge_of(sample)].at(way(sample));
    place.edge = edge_of(sample);
    return place;
}

} // namespace keiko
