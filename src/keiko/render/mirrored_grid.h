#pragma once

#include "keiko/render/mirrored_pixel.h"
#include "keiko/render/mirrored_rays.h"
#include "keiko/render/smooth_joins.h"

#include <optional>
#include <vector>

namespace keiko {

/// The mirrored rays of a grid of eye rays and where they begin. All are set before any is asked
/// for.
class MirroredGrid {
public:
    /// In pixels.
    MirroredGrid(int width, int height);

    std::size_t size() const { return rays_.size(); }
    /// Keeps the mirrored ray of a place, which is only looked at, and where it begins.
    void set(std::size_t place, const Ray& mirrored, const SurfacePlace& begin);
    /// Finds out which neighbours show one surface.
    void join();
    /// Nothing beside the grid's border and where the neighbours show something else.
    std::optional<PixelRays> around(std::size_t place) const;
    /// Whether there are such.
    bool is_amid(std::size_t place) const;
    bool at_border(std::size_t place) const;
    /// At least as many as places at the border.
    std::size_t most_at_border() const { return 2 * (width_ + height_); }
    std::size_t width() const { return width_; }
    /// The rays with differentials.
    const MirroredRays& rays() const { return numbers_; }

private:
    std::size_t width_, height_;
    std::vector<const Ray*> rays_;
    MirroredRays numbers_;
    std::vector<SurfacePlace> begins_;
    SmoothJoins joins_;
};

} // namespace keiko
