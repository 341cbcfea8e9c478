#pragma once

#include "keiko/inspect/overlaps/overlap.h"
#include "keiko/inspect/seams/model_borders.h"

#include <span>
#include <vector>

namespace keiko {

/// Bodies that pass through each other: faces joined by seams, of which a border passes through a
/// face of another body. One crossing for each pair of bodies, the steepest. On a way of the border
/// of `join` mm over sin `parallel_borders` either way, it leaves the tangent plane of the face by
/// more than half of `join` mm on both sides: parts that touch or are pressed into each other do
/// not count. Surfaces that cross without a border of either passing through the other are not
/// found.
std::vector<Overlap> body_crossings(const ModelBorders& borders, std::span<const Seam> seams,
                                    double join, const Job& job = {});

} // namespace keiko
