#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/inspect/basics/line_cells.h"
#include "keiko/inspect/basics/line_field.h"

#include <optional>

namespace KEIKO_API keiko {

/// A place on a line.
struct LinePoint {
    Vec2 uv{0};    ///< patch parameters
    Vec3 place{0}; ///< mm, on the exact surface
};

/// A smooth function of a patch's parameters whose zeros are curves on the patch.
class ZeroFunction {
public:
    virtual ~ZeroFunction() = default;

    /// Value at patch parameters.
    virtual double operator()(const Vec2& uv) const = 0;
    /// The place of the patch at its parameters.
    virtual LinePoint point(const Vec2& uv) const = 0;

    /// The root on the straight line between two places of opposite sign.
    Vec2 root(const Vec2& a, double at_a, const Vec2& b, double at_b) const;

    /// A point of the line between two others near each other on it, beside the given share of
    /// their chord; nullopt if no change of sign locates it.
    std::optional<LinePoint> between(const LinePoint& a, const LinePoint& b, double share) const;
};

/// The field's residual on one level as a function of the patch parameters: 0 on the line. Keeps
/// references; the patch and the field must outlive it.
class LevelFunction : public ZeroFunction {
public:
    /// `level` in the unit of the field.
    LevelFunction(const BezierPatchView& patch, const LineField& field, double level)
        : patch_(patch), field_(field), level_(level) {}

    /// The residual at patch parameters.
    double operator()(const Vec2& uv) const override;
    /// The place of the patch at its parameters.
    LinePoint point(const Vec2& uv) const override {
        return {uv, evaluate(patch_, uv, 0).position()};
    }

private:
    const BezierPatchView& patch_;
    const LineField& field_;
    double level_;
};

/// A connected piece of one level's line on a patch.
struct PatchLine {
    std::uint32_t level = 0; ///< index of a requested level
    bool closed = false;     ///< the last point is the first one again
    bool proved = true;      ///< runs through proved cells only; otherwise its course is likely,
                             ///< not certain
    std::vector<LinePoint> points; ///< from end to end
    double deviation = 0;          ///< mm, about the largest distance between curve and chords
};

/// Options of patch_lines.
struct PatchLineOptions {
    double chord_error = 0.01; ///< mm
    LineCellOptions cells;     ///< of the search for cells
};

/// The zeros of a function in its cells: one arc a cell, joined where arcs share an end, in the
/// order of the cells. Ends and inner points of an arc are found between places of opposite sign,
/// so that no step can leave the arc for another.
std::vector<PatchLine> lines_through(std::span<const LineCell> cells, const ZeroFunction& f,
                                     double chord_error);

/// All lines of the levels on a patch without its trims, by lines_through; by rising level.
std::vector<PatchLine> patch_lines(const BezierPatchView& patch, const LineField& field,
                                   std::span<const double> levels,
                                   const PatchLineOptions& options = {});

} // namespace keiko
