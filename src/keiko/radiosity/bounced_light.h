#pragma once

#include "keiko/base/job.h"
#include "keiko/math/rgb.h"
#include "keiko/radiosity/element_rows.h"

#include <span>
#include <vector>

namespace keiko {

/// Light of one lamp that faces of elements reflect onto each other.
struct BouncedLight {
    std::vector<Rgb> arriving;  ///< lx at each face from the others
    std::vector<Rgb> exitance;  ///< lm/m2 of each face by the lamp's direct light
    std::vector<Rgb> radiosity; ///< lm/m2 of each face by all light
    double remaining = 0;       ///< bound of the light that is left out, as a share of all
    int sweeps = 0;             ///< reflections that were followed
};

/// Solution of B = M + rho F B by gathering, a reflection after the other [GolubVanLoan2013],
/// section 11.2.1, until `remaining` is at most `allowed`. `areas`, `reflectances` and `exitance`
/// (M, lm/m2): one a face. A stop of the job ends it early.
BouncedLight bounced_light(const ElementRows& rows, std::span<const double> areas,
                           std::span<const Rgb> reflectances, std::vector<Rgb> exitance,
                           double allowed, const Job& job = {});

} // namespace keiko
