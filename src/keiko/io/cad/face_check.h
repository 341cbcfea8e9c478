#pragma once

#include <TopoDS_Face.hxx>

#include <string>

namespace keiko::cad {

/// What OpenCASCADE's own check has against a face by itself, a hint where to look when a picture
/// is odd; empty for a valid one. Several threads may check faces that share edges.
std::string fault_of(const TopoDS_Face& face);

} // namespace keiko::cad
