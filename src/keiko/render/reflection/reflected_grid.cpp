#include "keiko/render/reflection/reflected_grid.h"

#include <algorithm>

namespace keiko {

ReflectedGrid::ReflectedGrid(int width, int height)
    : width_(static_cast<std::size_t>(width)),
      known_(width_ * static_cast<std::size_t>(height)),
      numbers_(known_.size()),
      begins_(known_.size()) {}

void ReflectedGrid::set(std::size_t place, const Ray& mirrored) {
    known_[place] = mirrored.differentials ? Known::differentials : Known::line;
    numbers_.set(place, mirrored);
}

void ReflectedGrid::take_over_rows(int height) {
    const std::size_t taken = 2 * width_, first = size() - taken;
    const auto from_first = [&](auto& places) {
        std::copy_n(places.begin() + static_cast<std::ptrdiff_t>(first), taken, places.begin());
    };
    numbers_.take_over(first, taken);
    from_first(begins_), from_first(known_);
    known_.resize(taken);
    known_.resize(width_ * static_cast<std::size_t>(height));
}

void ReflectedGrid::join() {
    std::vector<const SurfacePlace*> places(size());
    for (std::size_t i = 0; i < size(); ++i)
        if (known_[i] == Known::differentials) places[i] = &begins_[i];
    joins_ = SurfaceContinuity(static_cast<int>(width_), places);
}

bool ReflectedGrid::is_amid(std::size_t place) const {
    // The last of a row has no neighbour on its right, nor that of the last row below.
    return place > width_ && joins_.right(place) && joins_.down(place) && joins_.right(place - 1) &&
           joins_.down(place - width_);
}

Ray ReflectedGrid::ray(std::size_t place) const {
    Ray ray;
    ray.origin = numbers_.vector(ReflectedRays::origin, place);
    ray.direction = numbers_.vector(ReflectedRays::direction, place);
    if (known_[place] == Known::differentials) ray.differentials = numbers_.differentials(place);
    return ray;
}

std::optional<PixelRays> ReflectedGrid::around(std::size_t place) const {
    if (!is_amid(place)) return {};
    return PixelRays{ray(place), ray(place - 1), ray(place + 1), ray(place - width_),
                     ray(place + width_)};
}

} // namespace keiko
