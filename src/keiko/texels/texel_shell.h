#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/scene/texel_spec.h"
#include "keiko/texels/shell_lattice.h"
#include "keiko/texels/texel_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace keiko {

/// A tetrahedron of a shell, a sixth of one of its cells, in which places of the cell are linear
/// in those of the scene. Going from its first corner to the last one follows one axis after the
/// other.
struct ShellPart {
    int cell_u = 0, cell_v = 0;                          ///< of the lattice
    std::array<unsigned, 3> order{};                     ///< of the axes u, v and height
    Vec3 corner{0};                                      ///< mm, the place (0, 0, 0) of the cell
    std::array<Vec3, 3> axes{Vec3(0), Vec3(0), Vec3(0)}; ///< unit, along u, v and height
    std::array<Vec3, 3> slopes{Vec3(0), Vec3(0),
                               Vec3(0)}; ///< 1/mm, of the coordinates; 0: it has no volume
    bool trimmed = false;                ///< true if a border of the face may cross the cell

    /// Change of a place of the cell along a way in mm.
    Vec3 along(const Vec3& way) const {
        return {slopes[0].dot(way), slopes[1].dot(way), slopes[2].dot(way)};
    }
};

/// Part of a line, in mm from its begin, within a part of a shell.
struct ShellRun {
    double begin = 0, end = 0;
    const ShellPart* part = nullptr;
    Vec3 first{0}, change{0}; ///< place of the cell at 0, and its change by mm

    /// Place of the cell, 0 to 1 along u, v and height.
    Vec3 at(double t) const { return first + change * t; }
};

/// Texels over one placed face (docs/theory/texels.md#the-shell).
class TexelShell {
public:
    /// Shell of a face as an instance places it. Keeps a reference to the specification.
    TexelShell(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
               const TexelSpec& spec, std::shared_ptr<const TexelBlock> block);

    /// Specification that it was made of.
    const TexelSpec& spec() const { return *spec_; }
    /// The block that repeats.
    const TexelBlock& block() const { return *block_; }
    /// Nodes of the shell.
    const ShellLattice& lattice() const { return lattice_; }
    /// Box of the shell, mm.
    const Box3& bounds() const { return bounds_; }

    /// Runs of a segment through the shell by rising begin.
    std::vector<ShellRun> runs(const Segment& segment) const;
    /// Place of the block at one of a cell, which may lie beyond that: 0 to 1 along the height,
    /// any number along the others.
    Vec3 block_place(const ShellPart& part, const Vec3& in_cell) const {
        return {(part.cell_u + in_cell.x) * repeats_.x, (part.cell_v + in_cell.y) * repeats_.y,
                in_cell.z};
    }
    /// False at a place of a cell that the face's trim curves cut off.
    bool is_material(const ShellPart& part, const Vec3& in_cell) const;
    /// Fibres at a place of a cell, with their direction in the scene.
    Fibres fibres(const ShellPart& part, const Vec3& in_cell, int level) const;
    /// Calls `visit` at each sample of a run that has fibres, with its place of the cell, them and
    /// its length in mm, until it returns false. Samples of all runs lie in the same steps from 0
    /// on, so that none is there twice. At coarse levels, too, they lie closely in the shell.
    template <class Visit>
    void each_sample(const ShellRun& run, int level, const Visit& visit) const {
        const double length = std::min(step(level), spec_->thickness / 8);
        for (double k = std::ceil(run.begin / length - 0.5); (k + 0.5) * length < run.end; ++k) {
            const Vec3 at = run.at((k + 0.5) * length);
            const Fibres found = fibres(*run.part, at, level);
            if (!(found.extinction > 0) || !is_material(*run.part, at)) continue;
            if (!visit(at, found, length)) return;
        }
    }
    /// Optical depth from a place of a cell out of the shell, along a unit direction. The cell goes
    /// on as it is. It ends where it is more than `most`.
    double depth_outwards(const ShellPart& part, const Vec3& in_cell, const Vec3& towards,
                          int level, double most) const;
    /// By node of the lattice: whether a cell with texels has it.
    std::vector<bool> used_nodes() const;
    /// mm between samples at a level of the block.
    double step(int level) const { return block_->voxel() * (1 << level) / 2; }

private:
    void add_cell(int i, int j, bool trimmed);

    const TexelSpec* spec_;
    std::shared_ptr<const TexelBlock> block_;
    ShellLattice lattice_;
    std::shared_ptr<const TrimRegion> region_;
    Vec2 repeats_{1};              ///< blocks in a cell along u and v
    std::vector<ShellPart> parts_; ///< six of each cell
    Box3 bounds_{};
    std::shared_ptr<const BoxTree> tree_; ///< of the cells
};

} // namespace keiko
