#pragma once

#include "keiko/base/error.h"
#include "keiko/light/spotlight/beam_spread.h"

#include <string>

namespace keiko {

/// Summary of a luminaire file.
struct LuminaireFacts {
    std::string source;
    PhotometricWeb web;
    double flux = 0;              ///< lm, of the luminaire
    double largest_intensity = 0; ///< cd
    PrincipalSpreads beam{};      ///< at 1/2 of the largest intensity in the plane
    PrincipalSpreads field{};     ///< at 1/10 of it
    Diagnostics diagnostics{};    ///< contradictions between the header and the table
};

LuminaireFacts luminaire_facts(const std::string& source, PhotometricWeb web);

/// The summary for a terminal: one fact a line.
std::string luminaire_text(const LuminaireFacts& facts);

/// The summary as "keiko-luminaire-facts/1". Header: source, name, photometric_type ("A", "B",
/// "C"), symmetry, planes and vertical_angles {count, first, last} in degrees. Light: luminous_flux
/// and lamp_flux (null for absolute photometry) in lm, light_output_ratio, largest_intensity in cd
/// with its vertical and horizontal angle. Beam: beam_angle and field_angle (see full_angles_json),
/// beam_edges and field_edges (see edges_json). Further keys: opening [x, y, z] in mm, diagnostics
/// [{severity, entity, message}].
std::string luminaire_json(const LuminaireFacts& facts);

} // namespace keiko
