#pragma once

#include <span>

namespace keiko {

/// Cosines and sines of angles in turns, 2 pi `turns`, to 4e-16 for up to 1e9 turns; the compiler
/// makes vectors of it. All spans are of one size.
void sincos_2pi(std::span<const double> turns, std::span<double> cosines, std::span<double> sines);

} // namespace keiko
