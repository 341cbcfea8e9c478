#include "keiko/placement/unreached_regions.h"

#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace keiko {
namespace {

UnreachedBecause reason(const LampField& field, std::size_t i) {
    if (field.samples()[i].blocked) return UnreachedBecause::blocked;
    return field.hidden(i) ? UnreachedBecause::hidden : UnreachedBecause::beyond_lamps;
}

/// Joins samples that are neighbours in their picture and not reached for the same reason.
DisjointSets joined(const LampField& field) {
    using Cell = std::tuple<std::uint32_t, int, int>;
    DisjointSets groups(field.samples().size());
    std::map<Cell, std::size_t> cells;
    for (std::size_t i = 0; i < field.samples().size(); ++i) {
        if (field.reached(i)) continue;
        const ViewSample& s = field.samples()[i];
        const int x = static_cast<int>(s.pixel.x / s.edge),
                  y = static_cast<int>(s.pixel.y / s.edge);
        for (const Cell& before : {Cell{s.view, x - 1, y}, Cell{s.view, x, y - 1}})
            if (const auto found = cells.find(before);
                found != cells.end() && reason(field, found->second) == reason(field, i))
                groups.join(found->second, i);
        cells.emplace(Cell{s.view, x, y}, i);
    }
    return groups;
}

UnreachedRegion region_of(const LampField& field, const std::vector<std::size_t>& members) {
    const std::span<const ViewSample> samples = field.samples();
    UnreachedRegion region;
    region.view = samples[members.front()].view;
    region.because = reason(field, members.front());
    std::set<std::uint32_t> faces;
    Vec2 middle(0);
    double weight = 0;
    for (const std::size_t i : members) {
        const ViewSample& s = samples[i];
        weight += s.weight;
        middle += s.pixel * s.weight;
        region.box.extend(s.position());
        region.pixels.extend(s.pixel);
        faces.insert(s.face);
    }
    middle /= weight;
    const std::size_t nearest =
        *std::min_element(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
            return (samples[a].pixel - middle).length2() < (samples[b].pixel - middle).length2();
        });
    region.place = samples[nearest].position();
    region.faces.assign(faces.begin(), faces.end());
    region.share = weight / field.total_weight();
    return region;
}

} // namespace

std::string_view name_of(UnreachedBecause reason) {
    switch (reason) {
        case UnreachedBecause::blocked:
            return "mirrors the body";
        case UnreachedBecause::hidden:
            return "hidden by lamps";
        default:
            return "beyond the lamps";
    }
}

std::vector<UnreachedRegion> unreached_regions(const LampField& field, double least_share) {
    DisjointSets groups = joined(field);
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < field.samples().size(); ++i)
        if (!field.reached(i)) members[groups.root(i)].push_back(i);
    std::vector<UnreachedRegion> regions;
    for (const auto& [first, all] : members) {
        UnreachedRegion region = region_of(field, all);
        if (region.share >= least_share) regions.push_back(std::move(region));
    }
    std::stable_sort(regions.begin(), regions.end(),
                     [](const auto& a, const auto& b) { return a.share > b.share; });
    return regions;
}

} // namespace keiko
