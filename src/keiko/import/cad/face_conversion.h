#pragma once

#include "keiko/import/cad/face_loops.h"
#include "keiko/import/cad/surface_patches.h"

namespace keiko::cad {

/// A CAD face as rational Bezier patches and trim loops, in the coordinates of its part.
struct ConvertedFace {
    std::vector<SurfacePatch> patches;
    double approximated = 0; ///< mm; 0 where exact
    FaceLoops trim;
};

/// Converts a face (as face_loops its wires) and checks the patches against the CAD surface. Throws
/// Error (or what OpenCASCADE throws) when the face cannot be converted.
ConvertedFace convert_face(const TopoDS_Face& face, EdgeTable& edges,
                           const std::vector<TopoDS_Edge>& built);

/// "plane", "b-spline", ... of a face's surface.
std::string surface_kind(const TopoDS_Face& face);

} // namespace keiko::cad
