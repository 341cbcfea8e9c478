#pragma once

#include "keiko/light/spotlight/intensity_table.h"
#include "keiko/math/vec.h"

#include <optional>
#include <string>

namespace keiko {

/// Convention by which the angles of a luminaire file name directions [LM-63, section 3]
/// (docs/theory/spotlights.md#luminaire-files). In the luminaire's own frame z is up and x is H =
/// 0.
enum class PhotometricType {
    a, ///< V: elevation, H: azimuth from x, clockwise; head lamps
    b, ///< V: about the level axis y from straight down, H: towards that axis; floodlights
    c  ///< V: from straight down, H: about the vertical, the C angle; most luminaires
};

/// Figures of the flux in the header of a luminaire file. The table alone is computed with.
struct StatedFlux {
    std::optional<double> output_ratio{};   ///< flux of the luminaire over `reference`
    double reference = 0;                   ///< lm that the ratio refers to
    std::optional<double> downward_share{}; ///< of the luminaire's flux, below the horizontal
};

/// What a luminaire file tells of a luminaire's light.
struct PhotometricWeb {
    PhotometricType type = PhotometricType::c;
    IntensityTable candela; ///< cd
    std::string name{};     ///< of the luminaire, as the file has it
    double lamp_flux = 0;   ///< lm of its lamps; 0: not told, absolute photometry
    Vec3 opening{0};        ///< mm: along x, along y, height; 0: a point
    StatedFlux stated{};    ///< what the header says of the flux
};

/// cd into a unit direction of the luminaire's own frame.
double intensity(const PhotometricWeb& web, const Vec3& direction);

/// The unit direction of angles in degrees.
Vec3 web_direction(PhotometricType type, double vertical, double horizontal);

/// The direction that the type's angles lead from: straight down, or x of type A.
Vec3 web_axis(PhotometricType type);

/// The unit direction that many degrees off the axis: in the plane of H = `plane` of type C; of
/// types A and B in the plane of the axis that holds the horizontal (0) or the vertical (90).
Vec3 off_axis(PhotometricType type, double degrees, double plane);

} // namespace keiko
