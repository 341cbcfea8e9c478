#pragma once

#include "keiko/base/job.h"
#include "keiko/import/cad/cad_document.h"
#include "keiko/import/cad/face_conversion.h"

#include <optional>
#include <string>
#include <vector>

namespace keiko::cad {

/// A face of a document and what became of it.
struct FaceResult {
    TopoDS_Face shape;
    std::size_t part = 0; ///< into CadDocument::parts
    EdgeTable edges;      ///< those of the face, in the order they were met
    std::optional<ConvertedFace> converted;
    std::string loss;  ///< why there is none
    std::string fault; ///< what OpenCASCADE's own check has against the face; mostly empty
};

/// Converts and checks all faces, part by part, many at a time. Progress goes to `job` as "import",
/// from one share of it to another.
std::vector<FaceResult> convert_faces(const CadDocument& document, const Job& job, double from,
                                      double to);

} // namespace keiko::cad
