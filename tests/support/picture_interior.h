#pragma once

#include "keiko/film/film.h"
#include "keiko/raster/item_buffer.h"

#include <cstddef>
#include <cstdint>

namespace keiko::test {

/// Number of the item that a pixel shows.
inline std::uint32_t shown_at(const ItemBuffer& items, int x, int y) {
    return items.at(x, y);
}
/// First channel of a pixel.
inline float shown_at(const Image& image, int x, int y) {
    return *image.pixel(x, y);
}

/// True if all pixels around one show what it does; false at the border of the picture.
template <class Picture>
bool is_inside(const Picture& picture, int x, int y) {
    if (x < 1 || y < 1 || x + 1 >= picture.width || y + 1 >= picture.height) return false;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            if (shown_at(picture, x + i, y + j) != shown_at(picture, x, y)) return false;
    return true;
}

/// Number of pixels off the edges of `truth` in which another picture shows something else.
template <class Picture>
int wrong_inside(const Picture& truth, const Picture& other) {
    int wrong = 0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x)
            if (is_inside(truth, x, y) && shown_at(other, x, y) != shown_at(truth, x, y)) ++wrong;
    return wrong;
}

} // namespace keiko::test
