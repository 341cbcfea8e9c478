#pragma once

#include "keiko/import/cad/cad_document.h"

#include <XSControl_WorkSession.hxx>

#include <cstdint>
#include <unordered_map>

namespace keiko::cad {

/// Lines of the entities of a STEP file, by number.
using EntityLines = std::unordered_map<std::uint64_t, std::uint32_t>;

/// Notes in `document`, whose parts have been read, the faces that OpenCASCADE passed over.
///
/// Lost faces are those below a shape representation that are in no part. Shells and solids that
/// hold no face count as one, and the faces of a product whose occurrence is not placed are lost
/// too. Faces with a bound that was not translated, or with an offset surface whose base was made
/// smooth, go to CadDocument::misread. A remark counts the faces that gave no shape and that no
/// shape representation refers to: they are no material.
void note_step_losses(const opencascade::handle<XSControl_WorkSession>& session,
                      const EntityLines& lines, CadDocument& document);

} // namespace keiko::cad
