#include "keiko/maps/voronoi.h"

#include "keiko/maps/lattice_noise.h"

#include <limits>

namespace keiko {
namespace {

constexpr double to_share = 1 / 4294967296.0; ///< of random 32 bits

/// Index of a cube, and whether it can hold a point within a distance.
struct Cube {
    std::int32_t i, j, k;

    static double gap(std::int32_t cube, double x) {
        return std::max({cube - x, x - cube - 1, 0.0});
    }
    double distance2(const Vec3& p) const {
        return Vec3(gap(i, p.x), gap(j, p.y), gap(k, p.z)).length2();
    }
    Vec3 point(std::uint32_t seed) const {
        const auto share = [&](std::uint32_t axis) {
            return lattice_hash(i, j, k, 4 * seed + axis) * to_share;
        };
        return Vec3(i + share(1), j + share(2), k + share(3));
    }
};

/// Mean over space, by VoronoiValue, from 10^6 places.
double mean_of(VoronoiValue value) {
    switch (value) {
        case VoronoiValue::distance:
            return 0.5203;
        case VoronoiValue::ridge:
            return 0.1965;
        case VoronoiValue::cell:
            break;
    }
    return 0.5;
}

double value_of(const VoronoiPoints& points, VoronoiValue value) {
    switch (value) {
        case VoronoiValue::distance:
            return std::min(points.nearest, 1.0);
        case VoronoiValue::ridge:
            return std::min(points.next - points.nearest, 1.0);
        case VoronoiValue::cell:
            break;
    }
    return points.cell * to_share;
}

} // namespace

VoronoiPoints voronoi_points(const Vec3& place, std::uint32_t seed) {
    const Cube own{lattice_cell(place.x), lattice_cell(place.y), lattice_cell(place.z)};
    double nearest2 = std::numeric_limits<double>::infinity(), next2 = nearest2;
    VoronoiPoints found;
    const auto look = [&](const Cube& cube) {
        if (!(cube.distance2(place) < next2)) return;
        const double d2 = (cube.point(seed) - place).length2();
        if (d2 < nearest2) {
            next2 = nearest2, nearest2 = d2;
            found.cell = lattice_hash(cube.i, cube.j, cube.k, 4 * seed);
        } else {
            next2 = std::min(next2, d2);
        }
    };
    // Two points are always within the 27 cubes around, and so within 3.5 of the place.
    constexpr int ring_of_second = 3;
    for (int ring = 0; ring <= ring_of_second; ++ring)
        for (int i = -ring; i <= ring; ++i)
            for (int j = -ring; j <= ring; ++j) {
                const bool side = std::max(std::abs(i), std::abs(j)) == ring;
                for (int k = -ring; k <= ring; k += side || ring == 0 ? 1 : 2 * ring)
                    look({own.i + i, own.j + j, own.k + k});
            }
    found.nearest = std::sqrt(nearest2), found.next = std::sqrt(next2);
    return found;
}

double voronoi(const TexturePlace& place, VoronoiValue value, std::uint32_t seed) {
    const double share = octave_share(place.footprint());
    const double mean = mean_of(value);
    if (share == 0) return mean;
    return mean + share * (value_of(voronoi_points(place.at, seed), value) - mean);
}

} // namespace keiko
