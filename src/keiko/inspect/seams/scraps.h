#pragma once

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/seam_chain.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

/// A stretch of a seam that does not pass and is too short to be judged by itself.
struct Scrap {
    std::array<PlacedFace, 2> faces{}; ///< its sides; one face twice for a line inside it
    double length = 0;                 ///< mm
    double negligible = 0;             ///< mm: a shorter stretch is a scrap
    std::vector<SeamEnd> tips;         ///< the ends of its pieces, on both sides
};

/// The scraps that are judged after all, a flag each. Scraps are added up for each face, and along
/// each line in which they continue each other, whichever faces meet there. Those that are together
/// longer than their negligible length are judged. Two scraps continue each other if the way from a
/// tip of one to a tip of the other, of at most `join` mm, turns no corner (goes_on).
std::vector<bool> judged_scraps(std::span<const Scrap> scraps, double join);

} // namespace keiko
