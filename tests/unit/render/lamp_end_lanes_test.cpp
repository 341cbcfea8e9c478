// Results of the kernels for pixels at the ends of lamps, held against their rays one by one.
#include "keiko/light/tubes/tube_hit.h"
#include "keiko/render/reflection/lamp_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

using namespace keiko;

namespace {

constexpr std::size_t width = LampCoverageBatch::capacity + 2, first = width + 1;

bool has(std::uint32_t set, std::size_t lane) {
    return (set >> lane & 1) != 0;
}

/// Three lamps of 60 mm.
CPlane three_lamps(double length, double pitch, bool luminous_caps) {
    CPlane row;
    row.origin = {0, 0, 2000};
    row.u = {length, 0, 0}, row.v = {0, 3 * pitch, 0};
    row.lamps = 3, row.diameter = 60;
    row.luminous_caps = luminous_caps;
    return row;
}

/// Three rows of pixels of 30 mm that look in one direction, around the ends of lamps.
struct EndStrip {
    CPlane plane;
    Vec3 direction, dx{30, 4, 0}, dy{-5, 25, 0};
    ReflectedRays numbers{3 * width};

    EndStrip(const CPlane& row, const Vec3& towards, double end) : plane(row), direction(towards) {
        const CPlaneFrame frame(plane);
        middle_ = frame.at(end, frame.axis(1)) - direction * 2000;
        for (std::size_t i = 0; i < 3 * width; ++i) {
            Ray ray;
            ray.origin = origin(i, 0, 0), ray.direction = direction;
            ray.differentials = {dx, dy, Vec3(0), Vec3(0)};
            numbers.set(i, ray);
        }
    }
    /// Origin of a ray of a pixel.
    Vec3 origin(std::size_t place, double x, double y) const {
        return middle_ + dx * (static_cast<double>(place % width) - 4.5 + x) +
               dy * (static_cast<double>(place / width) - 1.0 + y);
    }
    /// The share of a grid of a pixel's rays that enter a tube where it shines.
    double truth(std::size_t place) const {
        constexpr int side = 80;
        const CPlaneFrame frame(plane);
        int lit = 0;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const Vec3 from = origin(place, (i + 0.5) / side - 0.5, (j + 0.5) / side - 0.5);
                const auto tube = nearest_tube(frame, from, direction);
                lit += tube && (!tube->cap || plane.luminous_caps) ? 1 : 0;
            }
        return lit / static_cast<double>(side * side);
    }

private:
    Vec3 middle_;
};

/// The kernels' pixels against their rays.
void expect_truth(const EndStrip& strip) {
    const CPlaneFrame frame(strip.plane);
    std::array<double, LampCoverageBatch::capacity> truth{};
    for (std::size_t lane = 0; lane < truth.size(); ++lane) truth[lane] = strip.truth(first + lane);
    EXPECT_TRUE(
        std::any_of(truth.begin(), truth.end(), [](double t) { return t > 0.1 && t < 0.9; }));
    for (const SimdLevel level : simd_levels()) {
        LampCoverageBatch looks;
        lamp_kernels(level).look({frame, MirrorModel::tube}, strip.numbers, first, width, true,
                                 looks);
        for (std::size_t lane = 0; lane < truth.size(); ++lane)
            EXPECT_NEAR(has(looks.missed, lane) ? 0 : looks.coverage[lane], truth[lane], 0.01)
                << strip.direction.x << ", " << strip.plane.u.x << ", " << strip.plane.v.y << ", "
                << strip.plane.luminous_caps << ", " << lane;
    }
}

} // namespace

// Along and across the lamps at once, so that the sides of a tube end in different places. Lamps
// are far from each other, and side by side so that they look closed, long or shorter than their
// rims.
TEST(LampEndLanes, EndLampsWhereRaysSeeTheirRims) {
    for (const Vec3& direction : {Vec3(1.5, 1, 1), Vec3(-2, 1.2, 1), Vec3(1, -4, 1)})
        for (const auto& [length, pitch] : {std::pair(1200.0, 200.0), {1200.0, 65.0}, {30.0, 65.0}})
            for (const double end : {0.0, length})
                for (const bool luminous_caps : {false, true})
                    expect_truth({three_lamps(length, pitch, luminous_caps), direction, end});
}
