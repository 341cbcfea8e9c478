#pragma once

#include "keiko/film/film.h"

#include <vector>

namespace keiko {

/// How far two pictures are apart in one channel, in the channel's unit.
struct ChannelDifference {
    double largest = 0;          ///< of |a - b|; infinity where only one of them is a number
    double root_mean_square = 0; ///< over all pixels
    int x = 0, y = 0;            ///< pixel of the largest, the first of equals
};

/// One entry a channel. Two values that are equal, or both not a number, do not differ. Throws
/// Error when the pictures differ in size or channels.
std::vector<ChannelDifference> image_difference(const Image& a, const Image& b);

} // namespace keiko
