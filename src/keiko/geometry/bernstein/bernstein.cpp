#include "keiko/geometry/bernstein/bernstein.h"

#include "keiko/geometry/bernstein/bernstein_rows.h"

#include <cassert>

namespace keiko {

std::array<BernsteinRow, 4> bernstein_derivatives(int degree, double t, int order) {
    assert(degree >= 0 && degree <= max_degree && order >= 0 && order <= 3);
    return bernstein_rows<max_degree + 1>(static_cast<std::size_t>(degree), t,
                                          static_cast<std::size_t>(order));
}

} // namespace keiko
