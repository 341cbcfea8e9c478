#pragma once

#include "keiko/base/job.h"
#include "keiko/compare/film_difference.h"
#include "keiko/compare/outline_shift.h"

namespace keiko {

/// What moved outlines have to do with the difference of two pictures.
struct OutlineDifference {
    std::size_t excused = 0; ///< pixels that differ, whose outlines moved within the tolerance
    std::size_t moved = 0;   ///< pixels whose outlines moved farther, or that show something else
    OutlineShift worst{};    ///< of both, by excess
    int x = 0, y = 0;        ///< pixel of the worst, the first of equals
    Image left_out{};        ///< 1 channel: 1 in the excused pixels

    bool within() const { return moved == 0; }
};

/// Measures the outlines in every pixel in which two pictures are found to differ: in silhouette
/// flips, and in pixels beyond the tolerance of a layer that have an outline in them or beside
/// them. The same for any number of threads. Reports stage "outlines". Throws Cancelled.
OutlineDifference outline_difference(const OutlineComparison& outlines, const Film& before,
                                     const Film& after, const FilmDifference& difference,
                                     const Camera& camera, const Job& job = {});

} // namespace keiko
