#pragma once

#include "keiko/film/film.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/math/bounds.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/render/shading/picture.h"
#include "keiko/scene/camera.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// The cells of a picture in which a model may be visible: no ray through any other hits it.
class ScreenBounds {
public:
    /// `boxes`: world, mm; the model is within them.
    ScreenBounds(const Camera& camera, std::span<const Box3> boxes);

    /// True if a pixel of the picture or beside its border may show the model.
    bool may_show(int x, int y) const {
        return shown_[static_cast<std::size_t>(cell_at(y)) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(cell_at(x))] != 0;
    }

private:
    static constexpr int cell = 4; ///< pixels a side
    /// The first row and column are beyond the picture's border.
    static int cell_at(int pixel) { return (pixel + cell) / cell; }

    int columns_, rows_;
    std::vector<std::uint8_t> shown_; ///< by row
};

/// A piece of the picture, pixels [x0, x1) x [y0, y1).
struct Tile {
    int x0, y0, x1, y1; ///< first column and row, and those behind the last

    /// Pixels a row.
    int width() const { return x1 - x0; }
    /// Number of rows.
    int height() const { return y1 - y0; }
};

/// The whole picture in pieces of that size, those at its right and lower border smaller.
std::vector<Tile> tiles_of(const Camera& camera, int width, int height);

/// The camera rays of a picture.
struct PictureRays {
    PreparedCamera camera; ///< that the rays come from
    /// Pixels that may show the model, others show only the background; nullopt in a
    /// medium and below a sky.
    std::optional<ScreenBounds> cover;

    /// Rays of a camera into a scene.
    PictureRays(const PictureScene& scene, const Camera& seen_by);
    /// True if the ray through a pixel, in the picture or beside its border, is needed.
    bool may_meet(int x, int y) const { return !cover || cover->may_show(x, y); }
};

/// A tile and the pixels around it; valid as long as `eye` is.
TileRays grid_of(const PictureRays& eye, const Tile& tile);

/// A film without hits: black, ids -1, depth infinite.
Film blank_film(int width, int height, std::span<const Aov> aovs);

/// Writes one sample a pixel into every layer of the film, for pixels of a row from (x, y) on.
void write_row(Film& film, int x, int y, std::span<const PixelSample> samples);

/// Replaces colour, coverage, luminance and illuminance of a pixel by the mean over samples,
/// `shares` of the pixel; the other layers keep the values of its centre.
void write_mean(Film& film, int x, int y, std::span<const PixelSample> samples,
                std::span<const double> shares);

/// Writes the pixels of a tile, one sample each, row by row. Returns the statistics of their hits.
HitStatistics write_samples(std::span<const PixelSample> samples, const Tile& tile, Film& film);
/// Writes the pixels of a tile whose rays miss the scene.
void write_unseen(const Integrator& integrator, const Tile& tile, Film& film);

} // namespace keiko
