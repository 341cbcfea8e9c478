#pragma once

#include "keiko/io/cad/cad_document.h"

#include <XSControl_WorkSession.hxx>

namespace keiko::cad {

/// Mirrors and scales the instances of a STEP file that are mapped items as their operators say:
/// OpenCASCADE only moves and turns them. An item that is no instance by itself, within another
/// item say, stays as it is and gets a warning.
void place_mapped_items(const opencascade::handle<XSControl_WorkSession>& session,
                        CadDocument& document);

} // namespace keiko::cad
