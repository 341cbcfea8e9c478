#pragma once

#include "keiko/base/job.h"
#include "keiko/math/rgb.h"
#include "keiko/radiosity/energy_balance.h"
#include "keiko/radiosity/exchange_areas.h"
#include "keiko/radiosity/reflector.h"

#include <span>
#include <vector>

namespace keiko {

/// When Gauss-Seidel iteration ends.
struct SweepOptions {
    double change = 1e-12;   ///< of any radiosity in a sweep, as a share of the largest; from 0
    int most_sweeps = 10000; ///< it ends then in any case
};

/// Radiosities with a bound of what they may be off by.
struct SweptRadiosity {
    std::vector<Rgb> radiosity; ///< lm/m2 of each element
    std::vector<Rgb> arriving;  ///< lx on each element from the others
    int sweeps = 0;             ///< over all elements
    /// lm/m2, bound of the error of any radiosity for these exchange areas, from the residual;
    /// infinite where elements reflect all light and none escapes.
    double error = 0;
    EnergyBalance balance; ///< of these radiosities
};

/// Solution of B = M + rho F B by Gauss-Seidel iteration [Goral1984], [GolubVanLoan2013] section
/// 11.2: in place, in the order of the elements, from B = M on. One reflector an element. Throws
/// Cancelled.
SweptRadiosity solve_by_gauss_seidel(const ExchangeAreas& areas,
                                     std::span<const Reflector> reflectors,
                                     const SweepOptions& options = {}, const Job& job = {});

} // namespace keiko
