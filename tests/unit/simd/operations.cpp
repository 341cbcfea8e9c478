#include "tests/unit/simd/operations.h"

#include "keiko/simd/batch.h"

namespace keiko::test {
namespace KEIKO_LEVEL {
namespace {

using keiko::KEIKO_LEVEL::Batch;
using keiko::KEIKO_LEVEL::lanes;

[[gnu::flatten]] void compute(const double* a, const double* b, const double* c, std::size_t count,
                              Results* results) {
    for (std::size_t first = 0; first < count; first += lanes)
        compute_all(Batch::load(a + first), Batch::load(b + first), Batch::load(c + first),
                    [&](std::size_t i, const Batch& value) {
                        double numbers[lanes];
                        value.store(numbers);
                        for (std::size_t lane = 0; lane < lanes; ++lane)
                            (results + first + lane)->data()[i] = numbers[lane];
                    });
}

} // namespace

Operations operations() {
    return compute;
}

} // namespace KEIKO_LEVEL
} // namespace keiko::test
