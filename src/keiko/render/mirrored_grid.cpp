#include "keiko/render/mirrored_grid.h"

namespace keiko {

MirroredGrid::MirroredGrid(int width, int height)
    : width_(static_cast<std::size_t>(width)),
      height_(static_cast<std::size_t>(height)),
      rays_(width_ * height_),
      numbers_(rays_.size()),
      begins_(rays_.size()) {}

void MirroredGrid::set(std::size_t place, const Ray& mirrored, const SurfacePlace& begin) {
    rays_[place] = &mirrored;
    if (mirrored.differentials) numbers_.set(place, mirrored);
    begins_[place] = begin;
}

void MirroredGrid::join() {
    std::vector<const SurfacePlace*> places(rays_.size());
    for (std::size_t i = 0; i < rays_.size(); ++i)
        if (rays_[i] && rays_[i]->differentials) places[i] = &begins_[i];
    joins_ = SmoothJoins(static_cast<int>(width_), places);
}

bool MirroredGrid::at_border(std::size_t place) const {
    const std::size_t x = place % width_, y = place / width_;
    return x == 0 || y == 0 || x + 1 == width_ || y + 1 == height_;
}

bool MirroredGrid::is_amid(std::size_t place) const {
    return !at_border(place) && joins_.right(place) && joins_.down(place) &&
           joins_.right(place - 1) && joins_.down(place - width_);
}

std::optional<PixelRays> MirroredGrid::around(std::size_t place) const {
    if (!is_amid(place)) return {};
    return PixelRays{*rays_[place], *rays_[place - 1], *rays_[place + 1], *rays_[place - width_],
                     *rays_[place + width_]};
}

} // namespace keiko
