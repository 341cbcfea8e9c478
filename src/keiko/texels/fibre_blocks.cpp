#include "keiko/texels/fibre_blocks.h"

#include "keiko/maps/lattice_noise.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// Threads after which a weave repeats.
int threads_of(Weave weave) {
    return weave == Weave::plain ? 2 : weave == Weave::twill ? 4 : 5;
}

/// True where a warp thread lies above a weft thread.
bool warp_above(Weave weave, int warp, int weft) {
    const int period = threads_of(weave);
    const auto turn = [&](int shift) { return (warp + shift + period * period) % period; };
    if (weave == Weave::plain) return turn(weft) == 0;
    if (weave == Weave::twill) return turn(weft) < 2;
    return turn(2 * weft) != 0;
}

/// Random numbers of a hair, 0 to 1, by its place in the block and what they are for.
struct HairRandom {
    int row, column;
    std::uint32_t seed;

    double operator()(int purpose) const {
        return lattice_hash(row, column, purpose, seed) / 4294967296.0;
    }
};

/// Lays a hair into a block.
void add_hair(const FurSpec& fur, const HairRandom& random, double cell, TexelBlock& block) {
    const double length = fur.length * (1 - fur.variation * random(0));
    const double azimuth = (fur.toward + fur.disorder * (2 * random(1) - 1)) * degree;
    const Vec3 over(std::cos(azimuth), std::sin(azimuth), 0), aside(-over.y, over.x, 0);
    const double first_turn = 2 * pi * random(2);
    Vec3 middle((random.column + random(3)) * cell, (random.row + random(4)) * cell, 0);
    const double curl = 2 * pi * fur.curl_radius * fur.curl_turns; // mm, of its helix around
    const auto steps = static_cast<int>(std::ceil(3 * (length + curl) / block.voxel()));
    const double step = length / steps;
    Vec3 before(0);
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const double angle = (fur.lean + fur.droop * share) * degree;
        const double turn = first_turn + 2 * pi * fur.curl_turns * share;
        // The helix opens over the first fifth, so that hairs begin at their roots.
        const double radius = fur.curl_radius * std::min(1.0, 5 * share);
        const Vec3 place = middle + (over * std::cos(turn) + aside * std::sin(turn)) * radius;
        if (const Vec3 way = place - before; i > 0 && way.length() > 0)
            block.add((place + before) / 2, way.normalized(), fur.width * way.length());
        before = place;
        middle += (over * std::sin(angle) + Vec3(0, 0, std::cos(angle))) * step;
    }
}

/// A number of the cells of a square, row by row, chosen by random numbers.
std::vector<int> chosen_cells(int count, int side, std::uint32_t seed) {
    constexpr int choice = 5; // what the random numbers are for
    std::vector<std::pair<double, int>> cells;
    for (int i = 0; i < side * side; ++i)
        cells.emplace_back(HairRandom{i / side, i % side, seed}(choice), i);
    std::nth_element(cells.begin(), cells.begin() + (count - 1), cells.end());
    std::vector<int> chosen;
    for (int i = 0; i < count; ++i) chosen.push_back(cells[static_cast<std::size_t>(i)].second);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

void fill(const TexelSpec& spec, const FurSpec& fur, TexelBlock& block) {
    const double stated = fur.hairs * fur.block * fur.block / 100;
    const int hairs = std::max(1, static_cast<int>(std::lround(stated)));
    const int side = static_cast<int>(std::ceil(std::sqrt(hairs)));
    for (const int cell : chosen_cells(hairs, side, spec.seed))
        add_hair(fur, {cell / side, cell % side, spec.seed}, fur.block / side, block);
}

/// Height of the middle of a thread above that of the cloth, and its slope, as shares of its swing;
/// `along`: in threads, from the middle of the first crossing.
struct Swing {
    double height, slope;
};
template <class Above>
Swing swing_at(double along, const Above& above) {
    const int crossing = static_cast<int>(std::floor(along));
    const double t = along - crossing;
    const double a = above(crossing) ? 1 : -1, b = above(crossing + 1) ? 1 : -1;
    return {a + (b - a) * (1 - std::cos(pi * t)) / 2, (b - a) * pi * std::sin(pi * t) / 2};
}

/// Fibres of the thread of one direction at a place: `across` it from the nearest middle and
/// `height` above that of the cloth, in mm.
Fibres thread_at(const TexelSpec& spec, const ClothSpec& cloth, const Swing& swing, double across,
                 double height, const Vec3& along) {
    const double lift = spec.thickness / 4, wide = cloth.spacing / 2, thick = spec.thickness / 4;
    const double x = across / wide, z = (height - lift * swing.height) / thick;
    // Threads grow thin over the outer tenth of their section.
    const double inside = std::clamp((1 - std::sqrt(x * x + z * z)) * 10, 0.0, 1.0);
    const double extinction = cloth.extinction * inside;
    const Vec3 way = (along * cloth.spacing + Vec3(0, 0, lift * swing.slope)).normalized();
    return {extinction, way * extinction};
}

void fill(const TexelSpec& spec, const ClothSpec& cloth, TexelBlock& block) {
    const auto [side, deep, high] = block.voxels();
    const double voxel = block.size().x / side;
    for (int k = 0; k < high; ++k)
        for (int j = 0; j < deep; ++j)
            for (int i = 0; i < side; ++i) {
                const double x = (i + 0.5) * voxel / cloth.spacing - 0.5; // in threads
                const double y = (j + 0.5) * voxel / cloth.spacing - 0.5;
                const double z = ((k + 0.5) / high - 0.5) * spec.thickness;
                const int warp = static_cast<int>(std::lround(y));
                const int weft = static_cast<int>(std::lround(x));
                const Swing up =
                    swing_at(x, [&](int at) { return warp_above(cloth.weave, warp, at); });
                const Swing down =
                    swing_at(y, [&](int at) { return !warp_above(cloth.weave, at, weft); });
                const Fibres a =
                    thread_at(spec, cloth, up, (y - warp) * cloth.spacing, z, Vec3(1, 0, 0));
                const Fibres b =
                    thread_at(spec, cloth, down, (x - weft) * cloth.spacing, z, Vec3(0, 1, 0));
                block.set({i, j, k}, a.extinction > b.extinction ? a : b);
            }
}

} // namespace

double block_side(const TexelSpec& spec) {
    if (const auto* fur = std::get_if<FurSpec>(&spec.fibres)) return fur->block;
    const ClothSpec& cloth = std::get<ClothSpec>(spec.fibres);
    return threads_of(cloth.weave) * cloth.spacing;
}

TexelBlock fibre_block(const TexelSpec& spec) {
    const double side = block_side(spec);
    const auto layers = static_cast<unsigned>(
        std::clamp(std::ceil(spec.voxels * spec.thickness / side), 2.0, 256.0));
    TexelBlock block(spec.voxels, static_cast<int>(std::bit_ceil(layers)),
                     Vec3(side, side, spec.thickness));
    std::visit([&](const auto& fibres) { fill(spec, fibres, block); }, spec.fibres);
    block.finish();
    return block;
}

} // namespace keiko
