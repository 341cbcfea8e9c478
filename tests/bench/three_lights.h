#pragma once

#include "tests/bench/table.h"

#include <filesystem>

namespace keiko::bench {

/// The smallest defects that a panel shows one eye under a point light, parallel light and twelve
/// tubes, by paint.
Table three_lights_table();

/// Behaviour of lines of the tubes at the seam, where black paint just shows that something is
/// wrong with it: the largest values of their crossings.
Table seen_lines_table();

/// Draws the same dents under the three lights, side by side, as a PNG.
void draw_three_lights(const std::filesystem::path& output);

} // namespace keiko::bench
