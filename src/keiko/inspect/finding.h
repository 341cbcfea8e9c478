#pragma once

#include "keiko/inspect/seam_measure.h"

#include <cstdint>
#include <string>
#include <vector>

namespace keiko {

/// One value that is over its limit or cannot be told from it.
struct Finding {
    std::string code; ///< SASIG / VDA 4955, e.g. "G-SU-LG"
    std::string rule; ///< ISO 10303-59 name, e.g. "gap_between_faces_related_to_an_edge", or empty
    std::string quantity;   ///< "gap", "angle", "curvature" or "curvature_slope"
    std::string unit;       ///< "mm", "deg", "1" (a share of 1) or "1/mm"
    std::string formula;    ///< of a curvature mismatch, or empty
    Worst worst;            ///< value, bound, limit, place, verdict
    std::uint32_t seam = 0; ///< into Inspection::seams
    std::string faces;      ///< "face 12 (fender-outer) | face 13"
    std::string message;    ///< one sentence
};

/// The findings of one measured seam (number `index`), in the order gap, angle, curvature, its
/// slope.
std::vector<Finding> findings_of(const MeasuredSeam& seam, std::uint32_t index);

} // namespace keiko
