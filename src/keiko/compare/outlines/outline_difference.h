#pragma once

#include "keiko/base/job.h"
#include "keiko/compare/outlines/film_difference.h"
#include "keiko/compare/outlines/outline_shift.h"

namespace keiko {

/// What the bodies themselves have to do with the difference of two pictures of them.
struct OutlineDifference {
    std::size_t excused = 0; ///< pixels that differ, whose outlines moved within the tolerance
    std::size_t moved = 0;   ///< pixels whose outlines moved farther, or that show something else
    std::size_t alike = 0;   ///< pixels that differ, in which both show the same surface and paint
    OutlineShift worst{};    ///< of the excused and the moved ones, by excess
    int x = 0, y = 0;        ///< pixel of the worst, the first of equals
    Image left_out{};        ///< 1 channel: 1 in the excused and the alike pixels

    bool within() const { return moved == 0; }
};

/// Inspects every pixel in which two pictures are found to differ: silhouette flips, and pixels
/// beyond the tolerance of a layer. Where the bodies have no outline and show the same, the
/// pictures differ by how they are rendered, or by what is mirrored, which is compared where it is.
/// The same for any number of threads. Reports stage "outlines". Throws Cancelled.
OutlineDifference outline_difference(const OutlineComparison& outlines, const Film& before,
                                     const Film& after, const FilmDifference& difference,
                                     const Camera& camera, const Job& job = {});

} // namespace keiko
