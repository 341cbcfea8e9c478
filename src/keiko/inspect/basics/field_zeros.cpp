#include "keiko/inspect/basics/field_zeros.h"

#include "keiko/inspect/basics/visible_pieces.h"

#include <algorithm>

namespace keiko {

LinePoint FieldZeros::point(const Vec2& uv) const {
    return {uv, patch_.middle + evaluate(view_, uv, 0).position()};
}

BernsteinField iso_field(bool by_u, double at) {
    constexpr double inwards = 1e-10;
    const double inside = std::clamp(at, inwards, 1 - inwards);
    return {by_u ? 1 : 0, by_u ? 0 : 1, {-inside, 1 - inside}, 0};
}

std::vector<PatchLine> material_pieces(std::span<const LineCell> cells, const FieldZeros& zeros,
                                       double chord_error, double step,
                                       const std::function<bool(const LinePoint&)>& material) {
    std::vector<PatchLine> pieces;
    for (const PatchLine& line : lines_through(cells, zeros, chord_error))
        for (PatchLine& piece : visible_pieces(line, zeros, step, material))
            pieces.push_back(std::move(piece));
    return pieces;
}

} // namespace keiko
