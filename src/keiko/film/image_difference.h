#pragma once

#include "keiko/film/film.h"

#include <cstddef>

namespace keiko {

// Arithmetic of images by OpenImageIO, on the calling thread alone. Images must be of one size.

/// 1 channel: |a - b| of the channel that differs most. Neither image may hold NaNs.
Image largest_difference(const Image& a, const Image& b);

/// 1 channel: the size of the largest value of a or b in any channel; infinity counts as the
/// largest float.
Image largest_size(const Image& a, const Image& b);

/// Distances (1 channel) as multiples of `absolute + relative * size`; a tolerance of 0 counts as
/// the least float. 0 for no distance, infinity for an infinite one.
Image in_tolerances(const Image& distance, const Image& size, double absolute, double relative);

/// The larger of both at each pixel.
Image larger_of(const Image& a, const Image& b);

/// Statistics of the pixels of one channel of numbers >= 0.
struct PixelStatistics {
    double largest = 0;          ///< value of any pixel
    int x = 0, y = 0;            ///< of the largest, the first of equals by rows
    double root_mean_square = 0; ///< infinity where a pixel is
    std::size_t above = 0;       ///< pixels above the limit
};
/// Statistics of the first channel of an image; `limit` is that of PixelStatistics::above.
PixelStatistics pixel_statistics(const Image& channel, double limit);

/// Display picture of the number of tolerances that two pictures are apart (1 channel): grey up to
/// 1, from yellow to red where it is beyond (100 and more), magenta where it is infinite.
Image difference_picture(const Image& excess);

} // namespace keiko
