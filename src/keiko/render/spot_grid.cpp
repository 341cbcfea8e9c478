#include "keiko/render/spot_grid.h"

namespace keiko {

SpotGrid::SpotGrid(int width, int height, std::span<const LitSpot> spots, std::size_t first_sample)
    : width_(width),
      height_(height),
      spots_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    std::vector<const SurfacePlace*> places(spots_.size());
    for (const LitSpot& spot : spots) {
        spots_[spot.sample - first_sample] = &spot;
        places[spot.sample - first_sample] = &spot.place;
    }
    joins_ = SmoothJoins(width, places);
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
