#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstddef>
#include <vector>

namespace keiko {

/// Fibres at a place: what a voxel holds.
struct Fibres {
    double extinction = 0; ///< 1/mm, alike in all directions
    /// Mean direction times the extinction. x and y go along the surface, z along its normal.
    Vec3 direction{0};
};

/// The block of voxels that repeats over a surface. Each coarser level of it has the means of eight
/// voxels, down to one voxel along the shorter side.
class TexelBlock {
public:
    /// Block without fibres, `side` voxels along x and y and `high` along z, powers of two, for a
    /// box of `size` mm.
    TexelBlock(int side, int high, const Vec3& size);

    /// Adds the weight, mm2 that fibres there hide of a view across, along a unit direction. It is
    /// spread over the eight voxels around a place in mm. Places repeat along x and y; what lies
    /// above or below the block is lost.
    void add(const Vec3& place, const Vec3& direction, double weight);
    /// Sets one voxel of the finest level.
    void set(const std::array<int, 3>& voxel, const Fibres& fibres);
    /// Computes the coarser levels.
    void finish();

    /// Fibres at a place from 0 to 1 along each side, trilinear between the middles of voxels; it
    /// repeats along x and y. `level`: from 0, the finest, to coarsest().
    Fibres at(const Vec3& place, int level) const;
    /// Number of the coarsest level.
    int coarsest() const { return static_cast<int>(levels_.size()) - 1; }
    /// Voxels along x, y and z of the finest level.
    std::array<int, 3> voxels() const {
        return {levels_[0].side, levels_[0].side, levels_[0].high};
    }
    /// mm, the shorter edge of a voxel of the finest level.
    double voxel() const;
    /// mm along x, y and z.
    const Vec3& size() const { return size_; }

private:
    using Voxel = std::array<float, 4>; ///< extinction, direction

    struct Level {
        int side = 1, high = 1;
        std::vector<Voxel> voxels; ///< x fastest, then y

        /// Index of a voxel; x and y repeat.
        std::size_t index(int x, int y, int z) const {
            const auto wrapped = [this](int i) { return static_cast<std::size_t>(i & (side - 1)); };
            const auto wide = static_cast<std::size_t>(side);
            return wrapped(x) + wide * (wrapped(y) + wide * static_cast<std::size_t>(z));
        }
    };
    static Level coarser(const Level& level);

    Vec3 size_;
    std::vector<Level> levels_;
};

} // namespace keiko
