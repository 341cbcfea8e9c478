#include "keiko/trace/narrowed_roots.h"

#include "keiko/trace/plane_pair.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// More boxes than rays need that are not tangent to within rounding.
constexpr std::size_t most_boxes = 400;
/// Of the leaf's half size: what is narrower and still undecided is a tangency.
constexpr double narrowest = 1e-7;

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

bool same(const LeafBox& a, const LeafBox& b) {
    constexpr double rounding = 1e-14;
    return std::abs(a.x - b.x) <= a.half_x + b.half_x + rounding &&
           std::abs(a.y - b.y) <= a.half_y + b.half_y + rounding;
}

/// All roots, each once; nothing when the boxes do not come to an end.
class BoxSearch {
public:
    BoxSearch(const FrameRay& ray, const LeafKernels& kernels, const HotLeaf& leaf,
              const Component4* polynomial)
        : ray_(ray), kernels_(kernels), leaf_(leaf), polynomial_(polynomial) {
        // A vector full of them, from the first step on.
        for (const double x : {-0.75, -0.25, 0.25, 0.75})
            for (const double y : {-0.5, 0.5}) open_.push_back({x, y, 0.25, 0.5});
    }

    bool run() {
        for (std::size_t seen = 0; !open_.empty();) {
            std::array<LeafBox, 16> boxes;
            const std::size_t count = std::min<std::size_t>(8, open_.size());
            std::copy_n(open_.end() - static_cast<std::ptrdiff_t>(count), count, boxes.begin());
            open_.resize(open_.size() - count);
            const std::size_t left =
                kernels_.narrow(ray_.planes, leaf_, polynomial_, count, boxes.data());
            seen += count;
            if (seen > most_boxes) return false;
            for (std::size_t i = 0; i < left; ++i)
                if (!keep(boxes[i])) return false;
        }
        return true;
    }
    const std::vector<LeafBox>& roots() const { return roots_; }

private:
    bool keep(const LeafBox& box) {
        if (!box.root) {
            open_.push_back(box);
            return box.single || std::max(box.half_x, box.half_y) > narrowest;
        }
        const auto twin = std::find_if(roots_.begin(), roots_.end(),
                                       [&](const LeafBox& known) { return same(known, box); });
        if (twin == roots_.end()) roots_.push_back(box);
        return true;
    }

    const FrameRay& ray_;
    const LeafKernels& kernels_;
    const HotLeaf& leaf_;
    const Component4* polynomial_;
    std::vector<LeafBox> open_, roots_;
};

} // namespace

bool narrowed_roots(const TracedModel& model, const LeafKernels& kernels, std::uint32_t placed,
                    const TracedRay& ray, std::vector<Crossing>& found) {
    const HotLeaf& leaf = model.hot[placed];
    const Component4* polynomial = &model.leaves.polynomials[leaf.polynomial];
    const FrameRay seen = frame_ray(ray, leaf);
    BoxSearch search(seen, kernels, leaf, polynomial);
    if (!search.run()) return false;
    for (const LeafBox& root : search.roots()) {
        const Component4 c = evaluate(leaf, polynomial, root.x, root.y);
        found.push_back({.t = ray.t_at(seen.s_at(Vec3(c[0], c[1], c[2]) / c[3])),
                         .leaf = placed,
                         .uv = Vec2(root.x + 1, root.y + 1) * 0.5,
                         .error = Vec2(root.half_x, root.half_y) * 0.5});
    }
    return true;
}

} // namespace keiko
