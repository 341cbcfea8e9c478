// grids of fog densities
#include "keiko/files/scene/rig_tables.h"

#include "tests/fuzz/fuzz_target.h"

#include <cmath>

namespace {

using namespace keiko;

/// Along segments that cross the box of a grid, miss it, or end in it.
void require_sound(const VoxelDensity& density) {
    constexpr double far = 2e9; // beyond every corner of a grid
    for (const Vec3& end : {Vec3(far, far, far), Vec3(far, 0, 0), Vec3(1, 2, 3)}) {
        const Segment segment{-end, end};
        const double mean = density.mean_along(segment);
        fuzz::require(std::isfinite(mean) && mean >= 0, "a mean density is finite");
        for (const double t : density.crossings(segment))
            fuzz::require(t >= 0 && t <= 1, "a crossing lies on the segment");
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::accepts([&] { require_sound(parse_density(fuzz::text_of(data, size), "fuzz.density")); });
    return 0;
}
