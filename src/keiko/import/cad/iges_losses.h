#pragma once

#include "keiko/import/cad/cad_document.h"

#include <XSControl_Reader.hxx>

namespace keiko::cad {

/// Notes in `document`, whose parts have been read, what an IGES file has but OpenCASCADE passed
/// over.
///
/// Lost faces are those that a root entity leads to and that are in no part. Solids and shells that
/// gave no shape count as one where none of their faces is lost. Faces with fewer trim loops than
/// their entity states go to CadDocument::misread.
void note_iges_losses(XSControl_Reader& reader, CadDocument& document);

} // namespace keiko::cad
