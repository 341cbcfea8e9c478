#pragma once

#include "keiko/math/affine.h"

#include <gp_Trsf.hxx>

namespace keiko::cad {

inline Affine affine(const gp_Trsf& t) {
    Affine result;
    for (int i = 1; i <= 3; ++i)
        result.rows[static_cast<std::size_t>(i - 1)] = {t.Value(i, 1), t.Value(i, 2),
                                                        t.Value(i, 3)};
    result.translation = {t.Value(1, 4), t.Value(2, 4), t.Value(3, 4)};
    return result;
}

} // namespace keiko::cad
