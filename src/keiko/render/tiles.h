#pragma once

#include "keiko/film/film.h"
#include "keiko/intersect/hit/hit_statistics.h"
#include "keiko/render/screen_bounds.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/scene/camera.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A piece of the picture, pixels [x0, x1) x [y0, y1).
struct Tile {
    int x0, y0, x1, y1;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

/// The whole picture in pieces of that size, those at its right and lower border smaller.
std::vector<Tile> tiles_of(const Camera& camera, int width, int height);

/// The camera rays of a picture.
struct PictureRays {
    PreparedCamera camera;
    std::optional<ScreenBounds> cover; ///< others see nothing but the background

    PictureRays(const PictureScene& scene, const Camera& seen_by);
    bool may_meet(int x, int y) const { return !cover || cover->may_show(x, y); }
};

/// A tile and the pixels around it; valid as long as `eye` is.
TileRays grid_of(const PictureRays& eye, const Tile& tile);

/// Writes what the pixels of a tile show, and of `border` more on all sides. How many hits were
/// found in which way for the tile's own.
HitStatistics write_samples(std::span<const PixelSample> samples, int border, const Tile& tile,
                            Film& film);
/// Writes what pixels show of which no ray meets anything.
void write_unseen(const Integrator& integrator, const Tile& tile, Film& film);

} // namespace keiko
