#pragma once

#include "keiko/geometry/model/curve_set.h"

#include <string>
#include <string_view>

namespace keiko {

/// Bytes of a set of curves, for the worker: its numbers little-endian, texts after their lengths.
std::string serialize(const CurveSet& set);

/// The set of curves in `bytes`. Throws Error naming `file` when they are damaged, or hold a curve
/// that cannot be. Its degree is 1..max_degree, its knots never fall, its numbers are finite and
/// its weights positive.
CurveSet deserialize_curves(std::string_view bytes, const std::string& file);

} // namespace keiko
