#pragma once

#include "keiko/geometry/bernstein/bernstein_field.h"
#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/inspect/basics/placed_face.h"

#include <functional>

namespace keiko {

/// The pieces of a line on which `visible` holds. The predicate is evaluated at the line's points
/// and at points between them at most about `step` mm apart, or a sixteenth of that where the box
/// of two such points is `bordered`. A change and its reverse within that may be missed. Where its
/// value changes, the place is bisected on the line to 1e-9 mm, and the piece ends on the visible
/// side. A closed line that is visible as a whole stays closed.
std::vector<PatchLine> visible_pieces(const PatchLine& line, const ZeroFunction& f, double step,
                                      const std::function<bool(const LinePoint&)>& visible,
                                      const std::function<bool(const Box2&)>& bordered = {});

/// The zeros of a polynomial field on a placed patch. Keeps references to all; `view` is of the
/// patch's own points.
class FieldZeros : public ZeroFunction {
public:
    /// `field`: a polynomial in the patch's own parameters.
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
