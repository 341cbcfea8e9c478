#pragma once

#include "tests/bench/triangle_mesh.h"

class TopoDS_Shape;

namespace keiko::bench {

/// Mesh that BRepMesh_IncrementalMesh makes of a shape at a linear deflection in mm (angular
/// deflection at its default of 0.5 rad, one thread). The vertex normals are the surface's own.
TriangleMesh brep_mesh(const TopoDS_Shape& shape, double deflection, const Vec3& center);

} // namespace keiko::bench
