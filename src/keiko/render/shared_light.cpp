#include "keiko/render/shared_light.h"

#include "keiko/render/spot_grid.h"

#include <algorithm>
#include <array>

namespace keiko {
namespace {

using Cell = std::array<int, 2>;

/// The cells of one smooth surface around a cell, which are taken off the list of those to come.
std::vector<Cell> surface_around(const Cell& begin, const SpotGrid& grid,
                                 std::vector<bool>& to_come) {
    std::vector<Cell> surface{begin};
    to_come[grid.index(begin[0], begin[1])] = false;
    const auto add = [&](bool joined, int x, int y) {
        if (!joined || !to_come[grid.index(x, y)]) return;
        to_come[grid.index(x, y)] = false;
        surface.push_back({x, y});
    };
    for (std::size_t i = 0; i < surface.size(); ++i) {
        const auto [x, y] = surface[i];
        add(grid.goes_right(x, y), x + 1, y);
        add(grid.goes_down(x, y), x, y + 1);
        add(x > 0 && grid.goes_right(x - 1, y), x - 1, y);
        add(y > 0 && grid.goes_down(x, y - 1), x, y - 1);
    }
    return surface;
}

/// The cell nearest to the mean of all.
Cell amid(const std::vector<Cell>& cells) {
    const auto count = static_cast<double>(cells.size());
    Vec2 mean(0);
    for (const Cell& c : cells) mean += Vec2(c[0], c[1]) / count;
    return *std::min_element(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) {
        return (Vec2(a[0], a[1]) - mean).length2() < (Vec2(b[0], b[1]) - mean).length2();
    });
}

void light_pixel(const Integrator& integrator, const SpotGrid& grid, std::span<EyeSample> samples) {
    std::vector<bool> to_come(samples.size());
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) to_come[grid.index(x, y)] = grid.at(x, y) != nullptr;
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
            if (!to_come[grid.index(x, y)]) continue;
            const std::vector<Cell> surface = surface_around({x, y}, grid, to_come);
            const auto [mx, my] = amid(surface);
            const SpotLight light = integrator.light_on(*grid.at(mx, my));
            for (const auto& [cx, cy] : surface)
                integrator.add_light(*grid.at(cx, cy), light, samples[grid.index(cx, cy)]);
        }
}

} // namespace

void add_shared_light(const Integrator& integrator, int cells, EyeView& view) {
    const auto of_pixel = static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells);
    each_depth(view.spots, [&](std::span<const LitSpot> spots) {
        while (!spots.empty()) {
            const std::size_t pixel = spots[0].sample / of_pixel;
            std::size_t count = 1;
            while (count < spots.size() && spots[count].sample / of_pixel == pixel) ++count;
            const SpotGrid grid(cells, cells, spots.first(count), pixel * of_pixel);
            light_pixel(integrator, grid,
                        std::span(view.samples).subspan(pixel * of_pixel, of_pixel));
            spots = spots.subspan(count);
        }
    });
}

} // namespace keiko
