#pragma once

#include "keiko/base/job.h"
#include "keiko/io/cad/cad_document.h"

namespace keiko::cad {

/// Notes on the faces of a document that OpenCASCADE's own check calls invalid, numbered as
/// Face::id: a hint where to look when a picture is odd. Each face is checked by itself, many at a
/// time.
Diagnostics invalid_faces(const CadDocument& document, const Job& job);

} // namespace keiko::cad
