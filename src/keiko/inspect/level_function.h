#pragma once

#include "keiko/inspect/line_field.h"
#include "keiko/inspect/patch_lines.h"
#include "keiko/patch/bezier_patch.h"

#include <optional>

namespace keiko {

/// The field's residual on one level as a function of the patch parameters: 0 on the line. Keeps
/// references; the patch and the field must outlive it.
class LevelFunction {
public:
    LevelFunction(const BezierPatchView& patch, const LineField& field, double level)
        : patch_(patch), field_(field), level_(level) {}

    double operator()(const Vec2& uv) const;
    LinePoint point(const Vec2& uv) const { return {uv, evaluate(patch_, uv, 0).position()}; }

    /// Between two places of opposite sign, by the Illinois form of the secant rule (Dowell and
    /// Jarratt 1971), which keeps the root between its ends; halving where that is slow.
    Vec2 root(Vec2 a, double at_a, Vec2 b, double at_b) const;

    /// A point of the line between two others near each other on it, beside the given share of
    /// their chord; nothing where no change of sign tells it.
    std::optional<LinePoint> between(const LinePoint& a, const LinePoint& b, double share) const;

private:
    const BezierPatchView& patch_;
    const LineField& field_;
    double level_;
};

} // namespace keiko
