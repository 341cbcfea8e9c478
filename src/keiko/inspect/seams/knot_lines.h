#pragma once

#include "keiko/inspect/seams/seam_measure.h"

#include <vector>

namespace keiko {

/// Measures the lines inside faces along which two patches meet with less than G2, as knots of high
/// multiplicity leave them, and those across which a placed face bends within the preset's
/// negligible length (bend_pieces): as seams of a face with itself, where its trims keep it.
/// In the order of the faces, of each in the order of its instances. A line breaks above 1e-4 mm,
/// 1e-4 degrees or, of its curvatures, 0.1 % and 2e-7 /mm of the face as it is not placed: digits
/// of files make less. Scraps are judged too, until excuse_scraps() takes them out of the verdict.
/// Faces that approximate the file's, and those at irregular points of cages, have knots of their
/// own and none of the file's: they are left out.
std::vector<MeasuredSeam> measure_knot_lines(const ModelBorders& borders,
                                             const CriteriaPreset& preset, const Job& job = {});

} // namespace keiko
