#pragma once

#include "keiko/base/memory.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/math/rgb.h"
#include "keiko/render/reflection/reflected_footprint.h"
#include "keiko/render/reflection/shading_point.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace keiko {

/// Rays as arrays of their numbers, so that neighbouring ones are read side by side: origin,
/// direction, and their derivatives by the picture's x and y.
class ReflectedRays {
public:
    static constexpr std::size_t numbers = 18;      ///< of each ray: six vectors
    static constexpr std::size_t origin = 0;        ///< first number of the origin
    static constexpr std::size_t direction = 3;     ///< first number of the direction
    static constexpr std::size_t origin_dx = 6;     ///< first number of the origin's slope by x
    static constexpr std::size_t origin_dy = 9;     ///< first number of the origin's slope by y
    static constexpr std::size_t direction_dx = 12; ///< first of the direction's slope by x
    static constexpr std::size_t direction_dy = 15; ///< first of the direction's slope by y

    ReflectedRays() = default;
    /// Rays of `count` places, with undefined numbers until they are set.
    explicit ReflectedRays(std::size_t count)
        : stride_(count + margin), values_(numbers * stride_) {}

    /// Sets the numbers of a place. Without differentials its derivatives stay as they were.
    void set(std::size_t place, const Ray& ray) {
        put(place, origin, ray.origin), put(place, direction, ray.direction);
        if (!ray.differentials) return;
        const RayDifferentials& d = *ray.differentials;
        put(place, origin_dx, d.origin_dx), put(place, origin_dy, d.origin_dy);
        put(place, direction_dx, d.direction_dx), put(place, direction_dy, d.direction_dy);
    }
    /// One of the numbers, for the rays from a place on; a vector may be read past the last.
    const double* at(std::size_t number, std::size_t place) const {
        return values_.data() + number * stride_ + place;
    }
    /// Three numbers from one on.
    Vec3 vector(std::size_t number, std::size_t place) const {
        return {*at(number, place), *at(number + 1, place), *at(number + 2, place)};
    }
    /// Ray of a place that was set with differentials; `load` makes a number from the address of
    /// the place's: of a batch the place is the first.
    template <class Real, class Load>
    PixelRayT<Real> ray(std::size_t place, const Load& load) const {
        const auto vector = [&](std::size_t number) {
            return Vec3T<Real>(load(at(number, place)), load(at(number + 1, place)),
                               load(at(number + 2, place)));
        };
        return {vector(origin),
                vector(direction),
                {vector(origin_dx), vector(origin_dy), vector(direction_dx), vector(direction_dy)}};
    }
    /// Rays of a place and its neighbours in a grid of a width, all set with differentials.
    template <class Real, class Load>
    PixelRaysT<Real> around(std::size_t place, std::size_t width, const Load& load) const {
        return {ray<Real>(place, load), ray<Real>(place - 1, load), ray<Real>(place + 1, load),
                ray<Real>(place - width, load), ray<Real>(place + width, load)};
    }
    /// Ray of a place that was set with differentials.
    PixelRay ray(std::size_t place) const {
        return ray<double>(place, [](const double* number) { return *number; });
    }

private:
    static constexpr std::size_t margin = 8;

    void put(std::size_t place, std::size_t number, const Vec3& v) {
        for (unsigned k = 0; k < 3; ++k) values_[(number + k) * stride_ + place] = v[k];
    }

    std::size_t stride_ = 0;
    std::vector<double, DefaultInitAllocator<double>>
        values_; ///< of places without a ray, anything
};

/// Reflected rays of a grid of camera rays, of unlimited length, and their starts. All are set
/// before any is read.
class ReflectedGrid {
public:
    /// Grid of a size in pixels.
    ReflectedGrid(int width, int height);

    /// Number of places.
    std::size_t size() const { return known_.size(); }
    /// Sets the start of the reflected ray of a place.
    void set_begin(std::size_t place, const SurfacePlace& begin) { begins_[place] = begin; }
    /// The reflected ray of a place.
    void set(std::size_t place, const Ray& mirrored);
    /// Determines which neighbours show one surface.
    void join();
    /// Ray as it was set, without its `excluded`.
    Ray ray(std::size_t place) const;
    /// Rays of a place and its neighbours; nullopt beside the grid's border and if the neighbours
    /// show something else.
    std::optional<PixelRays> around(std::size_t place) const;
    /// True if there are such.
    bool is_amid(std::size_t place) const;
    /// Number of places in a row.
    std::size_t width() const { return width_; }
    /// Numbers of all rays, by place.
    const ReflectedRays& rays() const { return numbers_; }

private:
    /// Known part of a place's ray.
    enum class Known : std::uint8_t { nothing, line, differentials };

    std::size_t width_;
    std::vector<Known> known_;
    ReflectedRays numbers_;
    std::vector<SurfacePlace> begins_;
    SurfaceContinuity joins_;
};

/// The first reflected rays of a grid's pixels, and their hits.
struct ReflectionBuffer {
    /// The reflected ray of one place.
    struct Way {
        bool goes_on = false;     ///< a reflected ray was traced
        const Hit* hit = nullptr; ///< of that ray, in `hits`; null if it leaves the body
        Rgb weight;               ///< of its path
    };

    /// Buffer for a grid of a size in pixels, without rays.
    ReflectionBuffer(int width, int height) : grid(width, height), ways(grid.size()) {}

    ReflectedGrid grid;     ///< the rays
    std::vector<Way> ways;  ///< by place
    std::vector<Hits> hits; ///< of the ways
};

inline ReflectedGrid::ReflectedGrid(int width, int height)
    : width_(static_cast<std::size_t>(width)),
      known_(width_ * static_cast<std::size_t>(height)),
      numbers_(known_.size()),
      begins_(known_.size()) {}

inline void ReflectedGrid::set(std::size_t place, const Ray& mirrored) {
    known_[place] = mirrored.differentials ? Known::differentials : Known::line;
    numbers_.set(place, mirrored);
}

inline void ReflectedGrid::join() {
    std::vector<const SurfacePlace*> places(size());
    for (std::size_t i = 0; i < size(); ++i)
        if (known_[i] == Known::differentials) places[i] = &begins_[i];
    joins_ = SurfaceContinuity(static_cast<int>(width_), places);
}

inline bool ReflectedGrid::is_amid(std::size_t place) const {
    // The last of a row has no neighbour on its right, nor that of the last row below.
    return place > width_ && joins_.right(place) && joins_.down(place) && joins_.right(place - 1) &&
           joins_.down(place - width_);
}

inline Ray ReflectedGrid::ray(std::size_t place) const {
    Ray ray;
    ray.origin = numbers_.vector(ReflectedRays::origin, place);
    ray.direction = numbers_.vector(ReflectedRays::direction, place);
    if (known_[place] == Known::differentials) ray.differentials = numbers_.ray(place).spread;
    return ray;
}

inline std::optional<PixelRays> ReflectedGrid::around(std::size_t place) const {
    if (!is_amid(place)) return {};
    return numbers_.around<double>(place, width_, [](const double* number) { return *number; });
}

} // namespace keiko
