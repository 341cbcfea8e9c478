#pragma once

#include <TopoDS_Face.hxx>

#include <string>

namespace keiko::cad {

/// The reason of the exception being handled, one line. Lack of memory is thrown on: it is not
/// the fault of one face.
std::string current_failure();

/// What is already known of a face's loops when it is checked.
enum class KnownLoops {
    nothing,
    one_forward_loop ///< one wire that is one loop, closed as it stands, its material on the left
};

/// What OpenCASCADE's own check has against a face by itself, a hint where to look when a picture
/// is odd; empty for a valid one. Finds what BRepCheck_Analyzer finds on the face, but stops at the
/// first fault, and does not ask which way a loop runs that is known to run forward: classifying
/// it costs more than all the rest. Several threads may check faces that share edges.
std::string fault_of(const TopoDS_Face& face, KnownLoops known);

} // namespace keiko::cad
