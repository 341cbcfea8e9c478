#pragma once

#include "keiko/base/error.h"

#include <TopoDS_Shape.hxx>
#include <XSControl_WorkSession.hxx>

#include <functional>
#include <string>
#include <vector>

namespace keiko::cad {

/// What OpenCASCADE's translator says that it mended, by face.
using FaceRemarks = std::function<std::vector<std::string>(const TopoDS_Shape& face)>;

/// The warnings of a finished transfer from a STEP or IGES file. Those on an entity that no face
/// is made from go to `diagnostics`.
FaceRemarks reader_remarks(const opencascade::handle<XSControl_WorkSession>& session,
                           Diagnostics& diagnostics);

} // namespace keiko::cad
