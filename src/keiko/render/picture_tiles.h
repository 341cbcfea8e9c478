#pragma once

#include "keiko/film/film.h"
#include "keiko/intersect/hit/path_counts.h"
#include "keiko/render/picture_cover.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/scene/prepared_camera.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A piece of the picture, pixels [x0, x1) x [y0, y1).
struct PictureTile {
    int x0, y0, x1, y1;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

/// The whole picture in pieces of that size, those at its right and lower border smaller.
std::vector<PictureTile> picture_tiles(const Camera& camera, int width, int height);

/// The eye rays of a picture.
struct PictureRays {
    PreparedCamera camera;
    std::optional<PictureCover> cover; ///< others see nothing but the background

    PictureRays(const PictureScene& scene, const Camera& seen_by);
    bool may_meet(int x, int y) const { return !cover || cover->may_show(x, y); }
};

/// A tile and the pixels around it; valid as long as `eye` is.
EyeGrid grid_of(const PictureRays& eye, const PictureTile& tile);

/// Writes what the pixels of a tile show, and of `border` more on all sides. How many hits were
/// found in which way for the tile's own.
PathCounts write_samples(std::span<const EyeSample> samples, int border, const PictureTile& tile,
                         Film& film);
/// Writes what pixels show of which no ray meets anything.
void write_unseen(const Integrator& integrator, const PictureTile& tile, Film& film);

} // namespace keiko
