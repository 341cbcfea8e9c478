#include "keiko/inspect/seam_chain.h"

#include "keiko/math/disjoint_sets.h"

#include <map>
#include <tuple>

namespace keiko {
namespace {

using FacePair = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

struct End {
    Vec3 position, tangent;

    /// One line goes on into the other, instead of turning a corner.
    bool continues(const End& other, double join) const {
        constexpr double sin_corner = 0.5; // 30 degrees
        return (position - other.position).length() <= join &&
               tangent.cross(other.tangent).length() <=
                   sin_corner * tangent.length() * other.tangent.length();
    }
};

struct Ends {
    End begin, end;

    Ends(const SurfaceCurve& curve, const BoundaryInterval& interval)
        : begin(end_at(curve, interval.begin)), end(end_at(curve, interval.end)) {}

    bool touch(const Ends& other, double join) const {
        return begin.continues(other.begin, join) || begin.continues(other.end, join) ||
               end.continues(other.begin, join) || end.continues(other.end, join);
    }

private:
    static End end_at(const SurfaceCurve& curve, double t) {
        const SurfaceCurve::Point point = curve.at(t);
        return {point.position, point.first};
    }
};

} // namespace

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
