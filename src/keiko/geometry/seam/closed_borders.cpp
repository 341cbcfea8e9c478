#include "keiko/geometry/seam/closed_borders.h"

#include "keiko/math/disjoint_sets.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace keiko {
namespace {

using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

Key key_of(const BoundaryInterval& border) {
    return {border.instance, border.face, border.curve};
}

/// True if intervals cover nearly all of a border, and nearly nothing twice.
bool cover_once(const std::vector<ParameterInterval>& parts) {
    constexpr double almost_all = 0.99, almost_once = 1.01;
    double sum = 0;
    for (const ParameterInterval& part : parts) sum += part.length();
    return IntervalSet(parts).measure() >= almost_all && sum <= almost_once;
}

} // namespace

double closing_join(const SurfaceModel& model) {
    constexpr double share = 1e-4, most = 0.5;
    return std::min(most, share * hull_bounds(model).size());
}

bool borders_close(const SurfaceModel& model, double join, const Job& job) {
    std::map<Key, std::vector<ParameterInterval>> met;
    for (const Seam& seam : pair_seams(model, join, job))
        for (const BoundaryInterval& side : {seam.a, seam.b})
            met[key_of(side)].push_back(
                {std::min(side.begin, side.end), std::max(side.begin, side.end)});
    const BoundaryCurves curves(model);
    const std::vector<BoundaryInterval> all = curves.all();
    return std::all_of(all.begin(), all.end(), [&](const BoundaryInterval& border) {
        return cover_once(met[key_of(border)]) || curves.curve(border).length(0, 1) < join;
    });
}

std::vector<std::size_t> connected_faces(const SurfaceModel& model, double join, const Job& job) {
    DisjointSets sets(model.faces.size());
    for (const Seam& seam : pair_seams(model, join, job)) sets.join(seam.a.face, seam.b.face);
    std::vector<std::size_t> numbers;
    for (std::size_t f = 0; f < model.faces.size(); ++f) numbers.push_back(sets.root(f));
    return numbers;
}

} // namespace keiko
