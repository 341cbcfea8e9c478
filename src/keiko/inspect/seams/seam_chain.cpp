#include "keiko/inspect/seams/seam_chain.h"

#include "keiko/math/disjoint_sets.h"

#include <map>
#include <tuple>

namespace keiko {
namespace {

using FacePair = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

struct Ends {
    SeamEnd begin, end;

    Ends(const SurfaceCurve& curve, const BoundaryInterval& interval) {
        const SurfaceCurve::Point first = curve.at(interval.begin), last = curve.at(interval.end);
        begin = {first.position, -first.first};
        end = {last.position, last.first};
    }

    bool touch(const Ends& other, double join) const {
        return goes_on(begin, other.begin, join) || goes_on(begin, other.end, join) ||
               goes_on(end, other.begin, join) || goes_on(end, other.end, join);
    }
};

} // namespace

SeamEnd end_of(const SeamProbe& probe, const SeamPart& part, bool last) {
    const SeamPoint& point = last ? part.end : part.begin;
    const Vec3 run = probe.run(point.t);
    return {point.place, last ? run : -run};
}

bool goes_on(const SeamEnd& from, const SeamEnd& into, double reach) {
    if (is_corner(from.out, -into.out)) return false;
    const Vec3 way = into.place - from.place;
    if (way.length() <= same_vertex) return true;
    return way.length() <= reach && !is_corner(from.out, way) && !is_corner(way, -into.out);
}

std::vector<std::vector<std::uint32_t>> seam_chains(const BoundaryCurves& curves,
                                                    std::span<const Seam> seams, double join) {
    std::vector<Ends> ends;
    std::map<FacePair, std::vector<std::uint32_t>> by_faces;
    DisjointSets sets(seams.size());
    for (std::uint32_t i = 0; i < seams.size(); ++i) {
        const BoundaryInterval &a = seams[i].a, &b = seams[i].b;
        ends.emplace_back(curves.curve(a), a);
        auto& same = by_faces[FacePair(a.instance, a.face, b.instance, b.face)];
        for (const std::uint32_t j : same)
            if (ends[i].touch(ends[j], join)) sets.join(i, j);
        same.push_back(i);
    }
    std::map<std::size_t, std::vector<std::uint32_t>> chains;
    for (std::uint32_t i = 0; i < seams.size(); ++i) chains[sets.root(i)].push_back(i);
    std::vector<std::vector<std::uint32_t>> result;
    result.reserve(chains.size());
    for (auto& [first, pieces] : chains) result.push_back(std::move(pieces));
    return result;
}

} // namespace keiko
