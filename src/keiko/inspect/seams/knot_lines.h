#pragma once

#include "keiko/inspect/seams/seam_measure.h"

#include <vector>

namespace keiko {

/// Measures lines inside faces as seams of a face with itself, within its trims, in the order of
/// the faces and of each face's instances. These are the lines along which two patches meet with
/// less than G2, as knots of high multiplicity leave them. So are the lines across which a placed
/// face bends within the preset's negligible length (bend_pieces). A line breaks above 1e-4 mm,
/// 1e-4 degrees or, for its curvatures, 0.1 % and 2e-7 /mm of the unplaced face: digits of files
/// cause less. Scraps are judged too, until excuse_scraps() takes them out of the verdict. Faces
/// that approximate the file's, and those at irregular points of cages, are left out: they have
/// knots of their own and none of the file's.
std::vector<MeasuredSeam> measure_knot_lines(const ModelBorders& borders,
                                             const CriteriaPreset& preset, const Job& job = {});

} // namespace keiko
