#pragma once

#include "keiko/geometry/bernstein/bernstein_field.h"
#include "keiko/inspect/basics/placed_patch.h"
#include "keiko/inspect/basics/zero_function.h"

#include <functional>

namespace keiko {

/// The zeros of a polynomial field on a placed patch. Keeps references to all; `view` is of the
/// patch's own points.
class FieldZeros : public ZeroFunction {
public:
    FieldZeros(const PlacedPatch& patch, const BezierPatchView& view, const BernsteinField& field)
        : patch_(patch), view_(view), field_(field) {}

    double operator()(const Vec2& uv) const override { return field_(uv); }
    LinePoint point(const Vec2& uv) const override;

private:
    const PlacedPatch& patch_;
    const BezierPatchView& view_;
    const BernsteinField& field_;
};

/// The line of constant u (`by_u`) or v as the zeros of a field. A side of the patch is placed a
/// rounding error inside of it, where the field has both signs.
BernsteinField iso_field(bool by_u, double at);

/// Every piece of the curves through the cells on which `material` holds, found by visible_pieces.
std::vector<PatchLine> material_pieces(std::span<const LineCell> cells, const FieldZeros& zeros,
                                       double chord_error, double step,
                                       const std::function<bool(const LinePoint&)>& material);

} // namespace keiko
