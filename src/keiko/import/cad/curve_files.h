#pragma once

#include "keiko/files/model/model_format.h"
#include "keiko/geometry/model/curve_set.h"

#include <filesystem>
#include <string>

namespace keiko::cad {

/// Bytes of a STEP or IGES file of curves in mm. Each curve of the set is a shape with its name and
/// colour: an edge, or a compound of edges, one a piece. Numbers keep 16 digits. Throws Error for a
/// curve that OpenCASCADE refuses.
std::string curve_file(const CurveSet& set, ModelFormat format);

/// The free curves of a STEP or IGES file, mm: those that bound no face. Each shape with curves is
/// one NamedCurve; its deviation is not known, and 0. Throws Error naming the file when it cannot
/// be read or holds no such curve.
CurveSet read_curves(const std::filesystem::path& path, ModelFormat format);

} // namespace keiko::cad
