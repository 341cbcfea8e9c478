#pragma once

#include "keiko/geometry/model/curve_set.h"

#include <TopoDS_Shape.hxx>

#include <vector>

class IGESControl_Writer;
class STEPCAFControl_Writer;

namespace keiko::cad {

// OpenCASCADE goes through the shapes of a document by their addresses when it writes names and
// colours, so that no two files are alike. These give them in the order of the set.

/// Gives the transferred curves their colours. `shapes`: one a curve of the set.
void add_step_colors(STEPCAFControl_Writer& writer, const CurveSet& set,
                     const std::vector<TopoDS_Shape>& shapes);

/// Gives the transferred curves their names and colours. `shapes`: one a curve of the set.
void add_iges_names_and_colors(IGESControl_Writer& writer, const CurveSet& set,
                               const std::vector<TopoDS_Shape>& shapes);

} // namespace keiko::cad
