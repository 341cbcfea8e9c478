#pragma once

#include "keiko/simd/level.h"
#include "keiko/simd/real.h"

#include <array>
#include <cstddef>

namespace keiko::test {

/// Results of the operations of a number on a triple (a, b, c), comparisons as 0 or 1.
using Results = std::array<double, 25>;

/// Fills `results` for `count` triples; `count` is a multiple of 8.
using Operations = void (*)(const double* a, const double* b, const double* c, std::size_t count,
                            Results* results);

KEIKO_OF_EVERY_LEVEL(Operations, operations)

/// Results of all operations, for a double or a batch. `store(i, value)` takes number i.
template <class Real, class Store>
void compute_all(const Real& a, const Real& b, const Real& c, const Store& store) {
    const auto truth = [](const auto& mask) { return select(mask, Real(1), Real(0)); };
    Real sum = a;
    sum += b;
    std::size_t i = 0;
    for (const Real& value : {a + b,
                              a - b,
                              a * b,
                              a / b,
                              -a,
                              a * b + c,
                              sum,
                              min(a, b),
                              max(a, b),
                              abs(a),
                              sqrt(a),
                              floor(a),
                              ceil(a),
                              copysign(a, b),
                              truth(a < b),
                              truth(a > b),
                              truth(a <= b),
                              truth(a >= b),
                              truth(a == b),
                              truth(is_finite(a)),
                              truth(a < b && b < c),
                              truth(a < b || b < c),
                              truth(!(a < b)),
                              select(a < b, b, c),
                              clamped(a, -1.0, 1.0)})
        store(i++, value);
}

} // namespace keiko::test
