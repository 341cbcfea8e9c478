#pragma once

namespace keiko::bench {

/// How much longer a search for t and uv takes on a face with a loop of 100 cubic curves than on
/// the same face without, as a share: packets, rays that hit both. Median over interleaved rounds.
double trimming_cost(int rounds);

} // namespace keiko::bench
