#include "keiko/render/shading/eye_band.h"

#include "keiko/intersect/kernels/prefetch.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace keiko {
namespace {

/// Makes the last row of a grid the second of one of `size` places. Its first is unused, as
/// everything is done there except determining the bend of the images below it.
template <class T>
void take_over_row(std::vector<T>& places, std::size_t width, std::size_t size, const T& blank) {
    std::copy(places.end() - static_cast<std::ptrdiff_t>(width), places.end(),
              places.begin() + static_cast<std::ptrdiff_t>(width));
    std::fill_n(places.begin(), width, blank);
    places.resize(2 * width);
    places.resize(size, blank);
}

} // namespace

void EyeBand::begin(const TileRays& grid, const PixelSample& unseen) {
    if (!grid.continues_above) {
        view.samples.assign(mirrors.grid.size(), unseen);
        return;
    }
    mirrors.grid.take_over_rows(grid.height);
    const auto width = static_cast<std::size_t>(grid.width);
    take_over_row(view.samples, width, mirrors.grid.size(), unseen);
    take_over_row(mirrors.ways, width, mirrors.grid.size(), {});
    above_ = std::exchange(mirrors.hits, {});
    std::move(view.hits.begin(), view.hits.end(), std::back_inserter(above_));
    view.hits.clear();
}

void EyeBand::announce(std::size_t place) const {
    prefetch(std::span(view.samples).subspan(place, 1));
    prefetch(std::span(mirrors.ways).subspan(place, 1));
    mirrors.grid.announce(place);
}

} // namespace keiko
