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
    /// Whether an outline runs between the pixel and one of its eight neighbours, or the surface's
    /// curvature jumps in it.
    bool cross(int x, int y) const;

private:
    struct Pixel {
        bool hit = false;
        bool mirrors_body = false;
        bool torn = false; ///< what it mirrors is not smooth
        SurfacePlace place{};
    };

    static bool differ(const Pixel& a, const Pixel& b);
    const Pixel& at(int x, int y) const;

    int width_, height_;
    std::vector<Pixel> pixels_;
};

} // namespace keiko
