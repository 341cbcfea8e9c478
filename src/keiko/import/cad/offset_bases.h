#pragma once

#include <Geom_OffsetSurface.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>

#include <string>

namespace keiko::cad {

/// mm: how far an offset surface, as a reader made it, is off the points of its base as the file
/// has it, moved along the base's normals. OpenCASCADE makes a base with a kink smooth before it
/// offsets it, and keeps the smooth one alone. Measured on a grid over each knot span of the base,
/// up to its knots from both sides; 0 where the base is as the file has it.
double offset_error(const Geom_OffsetSurface& read, const opencascade::handle<Geom_Surface>& base);

/// The offset surface of a shape's first face, without its own bounds; null for another surface and
/// for a shape without faces.
opencascade::handle<Geom_OffsetSurface> offset_surface_of(const TopoDS_Shape& shape);

/// mm: a larger error makes the face lost.
constexpr double offset_tolerance = 1e-4;

/// Why a face is lost whose reader smoothed the offset surface of this name by `error` mm.
std::string smoothed_by(const std::string& surface, double error);

} // namespace keiko::cad
