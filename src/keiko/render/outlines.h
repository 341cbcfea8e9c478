#pragma once

#include "keiko/render/integrator.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// Remembers of each pixel's centre what decides whether its neighbour shows the same smooth
/// thing; where it does not, an outline runs between them and one ray a pixel is not enough.
class Outlines {
public:
    Outlines(int width, int height);

    /// Safe from several threads for different pixels.
    void set(int x, int y, const EyeSample& sample);
    /// Whether an outline runs between the pixel and one of its eight neighbours.
    bool cross(int x, int y) const;

private:
    struct Place {
        bool hit = false;
        std::uint32_t paint = 0;
        bool mirrors_body = false;
        Vec3 position{0}, normal{0};
    };

    static bool differ(const Place& a, const Place& b);
    const Place& at(int x, int y) const;

    int width_, height_;
    std::vector<Place> places_;
};

} // namespace keiko
