#pragma once

#include "keiko/film/film.h"

#include <cstdint>

namespace keiko {

/// Spots and stripes of the reaction of Gray and Scott with diffusion, by the equations, rates of
/// diffusion and grid of [Pearson1993]: a periodic picture of one channel, 0 to 1. `feed` and
/// `kill` are F and k there. The same for the same arguments on every machine. A reaction that dies
/// out leaves 0 everywhere.
Image reaction_diffusion(double feed, double kill, std::uint32_t seed);

} // namespace keiko
