#include "keiko/volumes/clear_blocks.h"

#include <algorithm>
#include <limits>

namespace keiko {

ClearBlocks::ClearBlocks(const std::array<int, 3>& nodes, const std::vector<float>& extinctions) {
    for (std::size_t axis = 0; axis < 3; ++axis) count_[axis] = (nodes[axis] - 2) / side + 1;
    const auto wide = static_cast<std::size_t>(count_[0]);
    const auto deep = static_cast<std::size_t>(count_[1]);
    clear_.assign(wide * deep * static_cast<std::size_t>(count_[2]), 1);
    std::size_t node = 0;
    // A node between two blocks belongs to both.
    const auto blocks = [&](int at, std::size_t axis) {
        const int first = std::max(at - 1, 0) / side;
        return std::array{first, std::min(at / side, count_[axis] - 1)};
    };
    for (int z = 0; z < nodes[2]; ++z)
        for (int y = 0; y < nodes[1]; ++y)
            for (int x = 0; x < nodes[0]; ++x) {
                if (!(extinctions[node++] > 0)) continue;
                for (const int k : blocks(z, 2))
                    for (const int j : blocks(y, 1))
                        for (const int i : blocks(x, 0))
                            clear_[static_cast<std::size_t>(i) +
                                   wide * (static_cast<std::size_t>(j) +
                                           deep * static_cast<std::size_t>(k))] = 0;
            }
}

double ClearBlocks::leaves(const Vec3& origin, const Vec3& direction, double t) const {
    std::array<int, 3> block{};
    for (unsigned axis = 0; axis < 3; ++axis)
        block[axis] = std::clamp(static_cast<int>(origin[axis] + direction[axis] * t) / side, 0,
                                 count_[axis] - 1);
    if (!clear_[static_cast<std::size_t>(block[0] + count_[0] * (block[1] + count_[1] * block[2]))])
        return t;
    double end = std::numeric_limits<double>::infinity();
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const int face = (block[axis] + (direction[axis] > 0 ? 1 : 0)) * side;
        end = std::min(end, (face - origin[axis]) / direction[axis]);
    }
    return std::max(t, end);
}

} // namespace keiko
