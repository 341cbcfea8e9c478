#pragma once

#include "keiko/spotlight/photometric_web.h"

#include <string>

namespace keiko {

/// What is in a luminaire file.
struct LuminaireFacts {
    std::string source;
    PhotometricWeb web;
    double flux = 0;              ///< lm, of the luminaire
    double largest_intensity = 0; ///< cd
    /// Degrees between the directions where the intensity falls to 1/2 and to 1/10, in the planes
    /// 0 and 90 (see spread_angle).
    double beam_angle[2] = {}, field_angle[2] = {};
};

LuminaireFacts luminaire_facts(const std::string& source, PhotometricWeb web);

/// For a terminal: one fact a line.
std::string luminaire_text(const LuminaireFacts& facts);

/// "keiko-luminaire-facts/1": source, name, photometric_type ("A", "B", "C"), symmetry, planes and
/// vertical_angles {count, first, last} in degrees, luminous_flux and lamp_flux (null for absolute
/// photometry) in lm, light_output_ratio, largest_intensity in cd with its vertical and horizontal
/// angle, beam_angle and field_angle {plane_0, plane_90} in degrees, opening [x, y, z] in mm.
std::string luminaire_json(const LuminaireFacts& facts);

} // namespace keiko
