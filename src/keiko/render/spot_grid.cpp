#include "keiko/render/spot_grid.h"

namespace keiko {

SpotGrid::SpotGrid(int width, int height, std::span<const LitSpot> spots, std::size_t first_sample)
    : width_(width),
      height_(height),
      spots_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      joins_(spots_.size()) {
    for (const LitSpot& spot : spots) spots_[spot.sample - first_sample] = &spot;
    const auto joined = [](const LitSpot* a, const LitSpot* b) {
        return a && b && continues(a->place, b->place);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            joins_[index(x, y)] = {x + 1 < width && joined(at(x, y), at(x + 1, y)),
                                   y + 1 < height && joined(at(x, y), at(x, y + 1))};
}

bool SpotGrid::is_smooth(int x0, int y0, int x1, int y1) const {
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            if (!at(x, y)) return false;
            if (x < x1 && !goes_right(x, y)) return false;
            if (y < y1 && !goes_down(x, y)) return false;
        }
    return true;
}

} // namespace keiko
