#include "keiko/import/subdivision/limit_patches.h"

#include "keiko/import/subdivision/bspline_pieces.h"
#include "keiko/import/subdivision/lattice_fit.h"

#include <algorithm>
#include <tuple>

namespace keiko::subdivision {
namespace {

std::vector<Vec3> list(const BezierNet& net) {
    return {net.begin(), net.end()};
}

/// Sorts by base face, and within it by place.
struct Placed {
    PatchPlace place;
    LimitTable::Index index;

    auto key() const {
        return std::tuple(place.face, place.box.lower.y, place.box.lower.x, place.turned);
    }
};

} // namespace

std::vector<LimitPatch> quad_patches(const LimitTable& table, LimitTable::Index index) {
    const PatchPlace place = table.place(index);
    if (!table.exact(index))
        return {{place.box, 3, fit_square(3, [&](double u, double v) {
                     return table.evaluate(index, u, v).position;
                 })}};
    const SplineNet net = table.spline_net(index);
    const unsigned mask = table.border_mask(index);
    const double sharpness = table.crease_sharpness(index);
    if (!(sharpness > 0)) return {{place.box, 3, list(bezier_of_spline(net, mask))}};
    std::vector<LimitPatch> patches;
    for (const SplinePiece& piece : pieces_beside_crease(net, mask, sharpness)) {
        const Box2 box{place.base(piece.box.lower.x, piece.box.lower.y),
                       place.base(piece.box.upper.x, piece.box.upper.y)};
        patches.push_back({box, 3, list(piece.points)});
    }
    return patches;
}

std::vector<std::vector<LimitTable::Index>> patches_by_face(const LimitTable& table) {
    std::vector<Placed> order;
    for (const LimitTable::Index index : table.patches())
        order.push_back({table.place(index), index});
    std::sort(order.begin(), order.end(),
              [](const Placed& a, const Placed& b) { return a.key() < b.key(); });
    std::vector<std::vector<LimitTable::Index>> faces;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || order[i].place.face != order[i - 1].place.face) faces.emplace_back();
        faces.back().push_back(order[i].index);
    }
    return faces;
}

} // namespace keiko::subdivision
