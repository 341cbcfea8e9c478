#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/inspect/basics/line_field.h"
#include "keiko/inspect/basics/zero_function.h"

namespace keiko {

/// The field's residual on one level as a function of the patch parameters: 0 on the line. Keeps
/// references; the patch and the field must outlive it.
class LevelFunction : public ZeroFunction {
public:
    LevelFunction(const BezierPatchView& patch, const LineField& field, double level)
        : patch_(patch), field_(field), level_(level) {}

    double operator()(const Vec2& uv) const override;
    LinePoint point(const Vec2& uv) const override {
        return {uv, evaluate(patch_, uv, 0).position()};
    }

private:
    const BezierPatchView& patch_;
    const LineField& field_;
    double level_;
};

} // namespace keiko
