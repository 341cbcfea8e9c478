#pragma once

#include "keiko/light/tubes/width_samples.h"

namespace keiko {

/// Appends the lines of the ends and the middles of parts to be asked for: of slices that light
/// anything and of which it is not known what is seen.
void add_ends_and_middles(const LampWidth& width, std::span<const Slices> parts,
                          std::vector<Segment>& lines);
/// With what is seen of those lines, from `next` on, of each part that is seen by itself if
/// `part_by_part`.
void hide_ends_and_middles(const LampWidth& width, bool part_by_part, std::span<Slices> parts,
                           std::vector<IntervalSet>::const_iterator& next);

} // namespace keiko
