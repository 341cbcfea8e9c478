#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/light/spotlight/beam_spread.h"

#include <optional>
#include <string>

namespace KEIKO_API keiko {

/// Summary of a luminaire file.
struct LuminaireFacts {
    std::string source;           ///< path of the file
    PhotometricWeb web;           ///< contents of the file
    double flux = 0;              ///< lm, of the luminaire
    double largest_intensity = 0; ///< cd
    PrincipalSpreads beam{};      ///< at 1/2 of the largest intensity in the plane
    PrincipalSpreads field{};     ///< at 1/10 of it
    Diagnostics diagnostics{};    ///< contradictions between the header and the table
};

/// Summary of the contents of a luminaire file.
LuminaireFacts luminaire_facts(const std::string& source, PhotometricWeb web);

/// The summary for a terminal: one fact a line.
std::string luminaire_text(const LuminaireFacts& facts);

/// The summary as "keiko-luminaire-facts/1". Header: source, name, photometric_type ("A", "B",
/// "C"), symmetry, planes and vertical_angles {count, first, last} in degrees. Light: luminous_flux
/// and lamp_flux (null for absolute photometry) in lm, light_output_ratio, largest_intensity in cd
/// with its vertical and horizontal angle. Beam: beam_angle and field_angle {plane_0, plane_90} in
/// degrees, null if an edge is not reached, or all is dark. Edges: beam_edges and field_edges
/// {plane_0, plane_90}, each {positive {degrees, reached}, negative {degrees, reached}, opposite},
/// or null if all is dark. Further keys: opening [x, y, z] in mm, diagnostics
/// [{severity, entity, message}].
std::string luminaire_json(const LuminaireFacts& facts);

/// Spread in the plane 0 or 90 for a terminal, e.g. "C0-C180: 70 degrees: 60 towards C0, 10 towards
/// C180".
std::string spread_text(PhotometricType type, int plane, const std::optional<BeamSpread>& spread);

/// The polar curve of a luminaire as an SVG picture in the form of catalogues: the axis of its
/// angles points down, and the distance from the middle is the intensity in cd. A full line is the
/// plane of H = 0 and 180 (for types A and B the plane of the axis that holds the horizontal). A
/// dashed line is the plane across. The right half is that of H = 0 and 90.
std::string polar_curve_svg(const LuminaireFacts& facts);

} // namespace keiko
