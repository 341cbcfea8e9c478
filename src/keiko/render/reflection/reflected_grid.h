#pragma once

#include "keiko/intersect/kernels/prefetch.h"
#include "keiko/render/reflection/reflected_footprint.h"
#include "keiko/render/reflection/reflected_rays.h"
#include "keiko/render/reflection/surface_continuity.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace keiko {

/// The reflected rays of a grid of camera rays, which go on for ever, and where they begin. All are
/// set or taken over before any is asked for.
class ReflectedGrid {
public:
    /// In pixels.
    ReflectedGrid(int width, int height);

    std::size_t size() const { return known_.size(); }
    /// Asks for what set_begin() soon writes of a place.
    void announce(std::size_t place) const { prefetch(std::span(begins_).subspan(place, 1)); }
    /// Where the reflected ray of a place begins.
    void set_begin(std::size_t place, const SurfacePlace& begin) { begins_[place] = begin; }
    /// The reflected ray of a place.
    void set(std::size_t place, const Ray& mirrored);
    /// Makes the last two rows the first ones of a grid that is no higher; all others are to be
    /// set.
    void take_over_rows(int height);
    /// Finds out which neighbours show one surface.
    void join();
    /// As it was set, without its `excluded`.
    Ray ray(std::size_t place) const;
    /// Nothing beside the grid's border and where the neighbours show something else.
    std::optional<PixelRays> around(std::size_t place) const;
    /// Whether there are such.
    bool is_amid(std::size_t place) const;
    std::size_t width() const { return width_; }
    const ReflectedRays& rays() const { return numbers_; }

private:
    /// What is known of a place's ray.
    enum class Known : std::uint8_t { nothing, line, differentials };

    std::size_t width_;
    std::vector<Known> known_;
    ReflectedRays numbers_;
    std::vector<SurfacePlace> begins_;
    SurfaceContinuity joins_;
};

} // namespace keiko
