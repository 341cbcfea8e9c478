#pragma once

#include "keiko/drawing/sheet/sheet.h"

#include <string>

namespace keiko {

/// A sheet as SVG 1.1: a unit is a mm, a group a layer, named as editors of vector drawings read
/// it. Coordinates are rounded to 0.01 mm.
std::string svg_sheet(const Sheet& sheet);

/// A sheet as DXF of AutoCAD R12, which every CAD program reads: polylines and texts in mm on
/// layers of its own, hidden ones of the line type DASHED. Coordinates are rounded to 0.001 mm.
/// Letters outside of ASCII become '?'.
std::string dxf_sheet(const Sheet& sheet);

/// A sheet as PDF 1.5 with one page: layers that a viewer can hide, texts in Helvetica. Letters
/// outside of Latin-1 become '?'.
std::string pdf_sheet(const Sheet& sheet);

} // namespace keiko
