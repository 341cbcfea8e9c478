#include "keiko/texels/texel_block.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keiko {

TexelBlock::TexelBlock(int side, int high, const Vec3& size) : size_(size) {
    assert((side & (side - 1)) == 0 && (high & (high - 1)) == 0);
    const auto wide = static_cast<std::size_t>(side);
    levels_.push_back(
        {side, high, std::vector<Voxel>(wide * wide * static_cast<std::size_t>(high))});
}

double TexelBlock::voxel() const {
    const Level& finest = levels_.front();
    return std::min({size_.x / finest.side, size_.y / finest.side, size_.z / finest.high});
}

void TexelBlock::add(const Vec3& place, const Vec3& direction, double weight) {
    Level& finest = levels_.front();
    const Vec3 voxel(size_.x / finest.side, size_.y / finest.side, size_.z / finest.high);
    const double density = weight / (voxel.x * voxel.y * voxel.z);
    const Vec3 at = place / voxel - Vec3(0.5);
    std::array<int, 3> first{};
    Vec3 t(0);
    for (unsigned axis = 0; axis < 3; ++axis) {
        first[axis] = static_cast<int>(std::floor(at[axis]));
        t[axis] = at[axis] - first[axis];
    }
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
        if (first[2] + z < 0 || first[2] + z >= finest.high) continue;
        const double share = (x ? t.x : 1 - t.x) * (y ? t.y : 1 - t.y) * (z ? t.z : 1 - t.z);
        Voxel& sum = finest.voxels[finest.index(first[0] + x, first[1] + y, first[2] + z)];
        const double own = density * share;
        sum[0] += static_cast<float>(own);
        for (unsigned axis = 0; axis < 3; ++axis)
            sum[axis + 1] += static_cast<float>(own * direction[axis]);
    }
}

void TexelBlock::set(const std::array<int, 3>& voxel, const Fibres& fibres) {
    Level& finest = levels_.front();
    const Vec3& way = fibres.direction;
    finest.voxels[finest.index(voxel[0], voxel[1], voxel[2])] = {
        static_cast<float>(fibres.extinction), static_cast<float>(way.x), static_cast<float>(way.y),
        static_cast<float>(way.z)};
}

void TexelBlock::finish() {
    while (levels_.back().side > 1 && levels_.back().high > 1)
        levels_.push_back(coarser(levels_.back()));
}

TexelBlock::Level TexelBlock::coarser(const Level& level) {
    Level half{level.side / 2, level.high / 2, {}};
    for (int z = 0; z < half.high; ++z)
        for (int y = 0; y < half.side; ++y)
            for (int x = 0; x < half.side; ++x) {
                Voxel mean{};
                for (int corner = 0; corner < 8; ++corner) {
                    const Voxel& part = level.voxels[level.index(
                        2 * x + (corner & 1), 2 * y + (corner >> 1 & 1), 2 * z + (corner >> 2))];
                    for (unsigned i = 0; i < 4; ++i) mean[i] += part[i] / 8;
                }
                half.voxels.push_back(mean);
            }
    return half;
}

Fibres TexelBlock::at(const Vec3& place, int level) const {
    const Level& of = levels_[static_cast<std::size_t>(level)];
    const double x = place.x * of.side - 0.5, y = place.y * of.side - 0.5;
    const double z = std::clamp(place.z * of.high - 0.5, 0.0, of.high - 1.0);
    const double x0 = std::floor(x), y0 = std::floor(y);
    const int i = static_cast<int>(x0), j = static_cast<int>(y0), k = static_cast<int>(z);
    const auto s = static_cast<float>(x - x0), t = static_cast<float>(y - y0);
    const auto r = static_cast<float>(z - k);
    const auto row = [&](int b, int c) {
        const Voxel &first = of.voxels[of.index(i, b, c)],
                    &second = of.voxels[of.index(i + 1, b, c)];
        Voxel mean;
        for (unsigned n = 0; n < 4; ++n) mean[n] = first[n] + (second[n] - first[n]) * s;
        return mean;
    };
    const auto layer = [&](int c) {
        const Voxel first = row(j, c), second = row(j + 1, c);
        Voxel mean;
        for (unsigned n = 0; n < 4; ++n) mean[n] = first[n] + (second[n] - first[n]) * t;
        return mean;
    };
    const Voxel low = layer(k), high = layer(std::min(k + 1, of.high - 1));
    const auto between = [&](unsigned n) {
        return static_cast<double>(low[n] + (high[n] - low[n]) * r);
    };
    return {between(0), {between(1), between(2), between(3)}};
}

} // namespace keiko
