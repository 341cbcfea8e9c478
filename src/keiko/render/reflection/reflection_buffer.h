#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/math/rgb.h"
#include "keiko/render/reflection/reflected_grid.h"

#include <vector>

namespace keiko {

/// The first reflected rays of a grid's pixels, and what they meet.
struct ReflectionBuffer {
    struct Way {
        bool goes_on = false;
        const Hit* hit = nullptr;
        Rgb weight; ///< of its path
    };

    ReflectionBuffer(int width, int height) : grid(width, height), ways(grid.size()) {}

    ReflectedGrid grid;
    std::vector<Way> ways;  ///< by place
    std::vector<Hits> hits; ///< of the ways
};

} // namespace keiko
