#include "keiko/import/subdivision/limit_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
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

namespace {

constexpr int degree = 4;
/// Width of what lies along a border: less than the smallest patch, so that none overlap.
constexpr double strip = 0x1p-12;
/// Box of the patches that touch no border: clear of the corner patches of the coarsest split.
const Box2 inside{Vec2(0.5, 0.25), Vec2(0.75, 0.75)};

// Edges of the base face begin at its vertices 0, 1 and 2; edge k lies on the side k of the
// face's parameters. Base parameters here are dyadic numbers, so comparing them is exact.

bool on_edge(const Vec2& p, int edge) {
    return edge == 0 ? p.y == 0 : edge == 1 ? p.x + p.y == 1 : p.x == 0;
}

/// The face's parameter along that side.
double along_edge(const Vec2& p, int edge) {
    return edge == 0 ? p.x : p.y;
}

/// The edge that both points lie on, or -1.
int shared_edge(const Vec2& a, const Vec2& b) {
    for (int edge = 0; edge < 3; ++edge)
        if (on_edge(a, edge) && on_edge(b, edge)) return edge;
    return -1;
}

/// A third of a triangle: its corner and the middles of the two edges there, u running along the
/// first, v along the second, each in the triangle's own parameters.
struct Third {
    Vec2 corner, toward_u, toward_v;

    Vec2 at(double u, double v) const {
        constexpr double third = 1.0 / 3;
        return (corner * (1 - u) + toward_u * u) * (1 - v) +
               (toward_v * (1 - u) + Vec2(third) * u) * v;
    }
};

const std::array<Third, 3> thirds{Third{{0, 0}, {0.5, 0}, {0, 0.5}},
                                  Third{{1, 0}, {0.5, 0.5}, {0.5, 0}},
                                  Third{{0, 1}, {0, 0.5}, {0.5, 0.5}}};

/// Parameters of a patch that is turned anticlockwise by quarters.
Vec2 turned_back(double u, double v, int quarters) {
    switch (quarters) {
        case 1:
            return {v, 1 - u};
        case 2:
            return {1 - u, 1 - v};
        case 3:
            return {1 - v, u};
        default:
            return {u, v};
    }
}

void set_range(Box2& box, int edge, double a, double b) {
    const unsigned axis = edge == 1 ? 1 : 0;
    box.lower[axis] = std::min(a, b);
    box.upper[axis] = std::max(a, b);
}

/// A strip along a side, its range still open.
Box2 strip_along(int edge) {
    if (edge == 0) return {Vec2(0), Vec2(1, strip)};
    if (edge == 1) return {Vec2(1 - strip, 0), Vec2(1)};
    return {Vec2(0, 1 - strip), Vec2(1)};
}

class TriangleLayout {
public:
    explicit TriangleLayout(const LimitTable& table) : table_(table) {}

    std::vector<LimitPatch> lay(const std::vector<LimitTable::Index>& triangles) {
        for (const LimitTable::Index index : triangles) {
            const PatchPlace place = table_.place(index);
            const SurfaceSample triangle = triangle_surface(table_, index);
            if (!place.turned && place.box.lower == Vec2(0))
                add_collapsed(triangle, place.box.upper.x);
            else
                for (const Third& third : thirds) add(triangle, place, third);
        }
        place_inner();
        return std::move(patches_);
    }

private:
    void add_collapsed(const SurfaceSample& triangle, double size) {
        patches_.push_back(
            {{Vec2(0), Vec2(size, 1)}, degree, fit_square(degree, [&](double u, double v) {
                 return triangle(u * (1 - v), u * v);
             })});
    }

    void add(const SurfaceSample& triangle, const PatchPlace& place, const Third& third) {
        const auto base = [&](const Vec2& p) { return place.base(p.x, p.y); };
        const Vec2 p = base(third.corner), q = base(third.toward_u), r = base(third.toward_v);
        // Anticlockwise, the sides along u and along v are those with the numbers 0 and 3.
        const int edge_u = shared_edge(p, q), edge_v = shared_edge(r, p);
        Box2 box = inside;
        if (edge_u >= 0 || edge_v >= 0) box = strip_along(edge_u >= 0 ? edge_u : edge_v);
        if (edge_u >= 0) set_range(box, edge_u, along_edge(p, edge_u), along_edge(q, edge_u));
        if (edge_v >= 0) set_range(box, edge_v, along_edge(r, edge_v), along_edge(p, edge_v));
        const int quarters = edge_u >= 0 ? edge_u : edge_v >= 0 ? (edge_v + 1) % 4 : 0;
        if (edge_u < 0 && edge_v < 0) inner_.push_back(patches_.size());
        patches_.push_back({box, degree, fit_square(degree, [&](double u, double v) {
                                const Vec2 own = turned_back(u, v, quarters);
                                const Vec2 at = third.at(own.x, own.y);
                                return triangle(at.x, at.y);
                            })});
    }

    void place_inner() {
        const auto side =
            static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(inner_.size()))));
        for (std::size_t i = 0; i < inner_.size(); ++i) {
            const Vec2 cell = inside.extent() / static_cast<double>(side);
            const std::size_t row = i / side, column = i % side;
            const Vec2 corner = Vec2(static_cast<double>(column), static_cast<double>(row));
            patches_[inner_[i]].box = {inside.lower + cell * corner,
                                       inside.lower + cell * (corner + Vec2(1))};
        }
    }

    const LimitTable& table_;
    std::vector<LimitPatch> patches_;
    std::vector<std::size_t> inner_; ///< into patches_
};

} // namespace

SurfaceSample triangle_surface(const LimitTable& table, LimitTable::Index index) {
    const SurfaceSample surface = [&table, index](double u, double v) {
        return table.evaluate(index, u, v).position;
    };
    return table.exact(index) ? surface : triangle_polynomial(surface);
}

std::vector<LimitPatch> triangle_patches(const LimitTable& table,
                                         const std::vector<LimitTable::Index>& triangles) {
    return TriangleLayout(table).lay(triangles);
}

} // namespace keiko::subdivision
