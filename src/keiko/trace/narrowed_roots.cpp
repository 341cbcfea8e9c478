#include "keiko/trace/narrowed_roots.h"

#include "keiko/trace/plane_pair.h"

#include <cmath>

namespace keiko {
namespace {

/// The components at a place, by Horner's scheme.
Component4 evaluate(const HotLeaf& leaf, const Component4* polynomial, double x, double y) {
    Component4 total{};
    const std::size_t columns = leaf.degree_v + 1u;
    for (std::size_t i = leaf.degree_u + 1u; i-- > 0;)
        for (std::size_t c = 0; c < 4; ++c) {
            double row = 0;
            for (std::size_t j = columns; j-- > 0;) row = row * y + polynomial[i * columns + j][c];
            total[c] = total[c] * x + row;
        }
    return total;
}

/// Whether two boxes hold one root: each was proved to hold no second.
bool same(const RootBoxes& roots, std::size_t a, std::size_t b) {
    constexpr double rounding = 1e-14;
    return std::abs(roots.x[a] - roots.x[b]) <= roots.half_x[a] + roots.half_x[b] + rounding &&
           std::abs(roots.y[a] - roots.y[b]) <= roots.half_y[a] + roots.half_y[b] + rounding;
}

bool is_new(const RootBoxes& roots, std::size_t index) {
    for (std::size_t i = 0; i < index; ++i)
        if (same(roots, i, index)) return false;
    return true;
}

} // namespace

bool narrowed_roots(const TracedModel& model, const LeafKernels& kernels, std::uint32_t placed,
                    const TracedRay& ray, std::vector<Crossing>& found) {
    const HotLeaf& leaf = model.hot[placed];
    const Component4* polynomial = &model.leaves.polynomials[leaf.polynomial];
    const FrameRay seen = frame_ray(ray, leaf);
    const Box2 where = reachable(seen, leaf);
    if (where.empty()) return true;
    RootBoxes roots;
    if (!kernels.find_roots(seen.planes, leaf, polynomial, where, roots)) return false;
    for (std::size_t i = 0; i < roots.count; ++i) {
        if (!is_new(roots, i)) continue;
        const Component4 c = evaluate(leaf, polynomial, roots.x[i], roots.y[i]);
        found.push_back({.t = ray.t_at(seen.s_at(Vec3(c[0], c[1], c[2]) / c[3])),
                         .leaf = placed,
                         .uv = Vec2(roots.x[i] + 1, roots.y[i] + 1) * 0.5,
                         .error = Vec2(roots.half_x[i], roots.half_y[i]) * 0.5});
    }
    return true;
}

} // namespace keiko
