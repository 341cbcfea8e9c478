#pragma once

#include <TopoDS_Face.hxx>

#include <string>

namespace keiko::cad {

/// The reason of the exception being handled, one line. Lack of memory is thrown on: it is not
/// the fault of one face.
std::string current_failure();

/// Knowledge of a face's loops before its check.
enum class KnownLoops {
    nothing,         ///< the wires may be anything
    one_forward_loop ///< one wire that is one loop, closed as it stands, its material on the left
};

/// Fault that OpenCASCADE's own check finds in a face by itself, a hint when a picture is odd;
/// empty for a valid face. Finds what BRepCheck_Analyzer finds on the face, but stops at the first
/// fault. The direction of a loop that is known to run forward is not tested: classifying it costs
/// more than all the rest. Several threads may check faces that share edges.
std::string fault_of(const TopoDS_Face& face, KnownLoops known);

} // namespace keiko::cad
