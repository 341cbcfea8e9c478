#include "keiko/inspect/basics/placed_derivatives.h"

namespace keiko {

SurfaceDerivatives placed_derivatives(const SurfaceModel& model, std::uint32_t instance,
                                      std::uint32_t patch, const Vec2& uv) {
    SurfaceDerivatives s = evaluate(model.patch(patch), uv, 3);
    const Affine& placed = model.instances[instance].transform;
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; k + l < 4; ++l) s.d[k][l] = placed.vector(s.d[k][l]);
    s.d[0][0] += placed.translation;
    return s;
}

} // namespace keiko
