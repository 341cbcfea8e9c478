#pragma once

#include "keiko/scene/volume_spec.h"
#include "keiko/volumes/voxel_grid.h"

#include "tests/support/oracle.h"

#include <cmath>

namespace keiko::test {

/// Values of the voxels that rows of the tables volume_emission and volume_levoy state: waves under
/// a bell.
template <class Number>
VoxelGridOf<Number> wave_voxels(const OracleRow& row) {
    const std::array<int, 3> nodes{row.integer("in.nx"), row.integer("in.ny"),
                                   row.integer("in.nz")};
    const double s = row.number("in.s");
    std::vector<Number> values;
    for (int k = 0; k < nodes[2]; ++k)
        for (int j = 0; j < nodes[1]; ++j)
            for (int i = 0; i < nodes[0]; ++i) {
                const Vec3 away(i - (nodes[0] - 1) / 2.0, j - (nodes[1] - 1) / 2.0,
                                k - (nodes[2] - 1) / 2.0);
                const double wave = std::sin(row.number("in.A") * i + 0.3) *
                                    std::cos(row.number("in.B") * j - 0.2) *
                                    std::sin(row.number("in.G") * k + 0.5);
                values.push_back(static_cast<Number>((0.5 + 0.5 * wave) *
                                                     std::exp(-away.length2() / (2 * s * s))));
            }
    return {nodes, std::move(values)};
}

/// Place of those voxels.
inline VoxelFiles wave_files(const OracleRow& row) {
    VoxelFiles files;
    files.origin = row.vector("in.lo");
    files.spacing = Vec3(row.number("in.sp"));
    return files;
}

/// A ray of such a row and its samples in the middle of steps from where it enters the box of the
/// nodes; the last step may go beyond the box.
struct WaveRay {
    Vec3 origin{0}, direction{0}, low{0};
    double spacing = 1, step = 1, begin = 0, end = 1;
    int count = 0;

    WaveRay(const OracleRow& row, const std::array<int, 3>& nodes)
        : origin(row.vector("in.O")),
          direction(row.unit("in.dir")),
          low(row.vector("in.lo")),
          spacing(row.number("in.sp")),
          step(row.number("in.dt")),
          end(1e9) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            const double a = (low[axis] - origin[axis]) / direction[axis];
            const double b = a + spacing * (nodes[axis] - 1) / direction[axis];
            begin = std::max(begin, std::min(a, b)), end = std::min(end, std::max(a, b));
        }
        count = static_cast<int>(std::ceil((end - begin) / step - 1e-9));
    }
    double t(int sample) const { return begin + (sample + 0.5) * step; }
    /// Place in steps between nodes.
    Vec3 place(double t) const { return (origin + direction * t - low) / spacing; }
    bool inside(double t) const { return t <= end; }
};

} // namespace keiko::test
