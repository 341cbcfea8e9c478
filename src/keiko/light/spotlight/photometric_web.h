#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Interpolation of a table between its vertical angles [NishitaSpots, eq. 7 and 8]; between its
/// planes it is always linear in the angle.
enum class TableInterpolation {
    linear, ///< in the angle
    cosine  ///< in its cosine: flat on the axis, like a symmetric lamp
};

/// Symmetry by which the planes of a table represent others
/// (docs/theory/spotlights.md#luminaire-files).
enum class PlaneSymmetry {
    none,             ///< the planes cover the full circle
    axial,            ///< one plane for all
    quadrant,         ///< 0 to 90 degrees, mirrored at both
    bilateral,        ///< 0 to 180 degrees, mirrored there
    bilateral_across, ///< 90 to 270 degrees, mirrored there
    lateral,          ///< 0 and up for both signs of the angle
    limited           ///< dark outside of the planes
};

/// Intensities over a grid of two angles in degrees, V (from the axis, or the elevation) and H
/// (about the axis, or the azimuth): the only look-up of tables in scenes and of luminaire files.
class IntensityTable {
public:
    /// Table of `values` plane by plane of `horizontal`, V fastest. Requires ascending angles, at
    /// least one of each, and as many values as both have together. PlaneSymmetry::none requires
    /// the planes of 0 to below 360 degrees, or up to 360.
    IntensityTable(std::vector<double> vertical, std::vector<double> horizontal,
                   std::vector<double> values, PlaneSymmetry symmetry,
                   TableInterpolation interpolation = TableInterpolation::linear);

    /// Intensity under angles in degrees; 0 outside of the vertical angles, and outside of the
    /// planes if these are limited or lateral.
    double operator()(double vertical, double horizontal) const;

    /// Vertical angles of the table, degrees, ascending.
    const std::vector<double>& vertical() const { return vertical_; }
    /// Horizontal angles of the planes, degrees, ascending.
    const std::vector<double>& horizontal() const { return horizontal_; }
    /// Value of plane `h` at vertical angle `v`, both by number.
    double value(std::size_t h, std::size_t v) const { return values_[h * vertical_.size() + v]; }
    /// How planes that are not there are completed.
    PlaneSymmetry symmetry() const { return symmetry_; }
    /// How values are interpolated.
    TableInterpolation interpolation() const { return interpolation_; }
    /// The largest intensity of the table.
    double largest() const;
    /// The largest vertical angle that is not dark in every plane, and beyond which all is dark;
    /// the next one if a value leads there. 0 if all is dark.
    double lit_up_to() const;

    bool operator==(const IntensityTable&) const = default;

private:
    double folded(double horizontal) const;

    std::vector<double> vertical_, horizontal_, values_;
    PlaneSymmetry symmetry_;
    TableInterpolation interpolation_;
};

/// Convention by which the angles of a luminaire file name directions [LM-63, section 3]
/// (docs/theory/spotlights.md#luminaire-files). In the luminaire's own frame z is up and x is H =
/// 0.
enum class PhotometricType {
    a, ///< V: elevation, H: azimuth from x, clockwise; head lamps
    b, ///< V: about the level axis y from straight down, H: towards that axis; floodlights
    c  ///< V: from straight down, H: about the vertical, the C angle; most luminaires
};

/// Figures of the flux in the header of a luminaire file. Only the table is used in computations.
struct StatedFlux {
    std::optional<double> output_ratio{};   ///< flux of the luminaire over `reference`
    double reference = 0;                   ///< lm that the ratio refers to
    std::optional<double> downward_share{}; ///< of the luminaire's flux, below the horizontal
};

/// Intensities and figures of a luminaire file.
struct PhotometricWeb {
    PhotometricType type = PhotometricType::c; ///< convention of its angles
    IntensityTable candela;                    ///< cd
    std::string name{};                        ///< of the luminaire, as in the file
    double lamp_flux = 0; ///< lm of its lamps; 0: not stated, absolute photometry
    Vec3 opening{0};      ///< mm: along x, along y, height; 0: a point
    StatedFlux stated{};  ///< flux by the header
};

/// cd in a unit direction of the luminaire's own frame.
double intensity(const PhotometricWeb& web, const Vec3& direction);

/// The unit direction of angles in degrees.
Vec3 web_direction(PhotometricType type, double vertical, double horizontal);

/// The direction from which the type's angles are measured: straight down, or x for type A.
Vec3 web_axis(PhotometricType type);

/// The unit direction at an angle of `degrees` from the axis. For type C it is in the plane of H =
/// `plane`. For types A and B it is in the plane of the axis that holds the horizontal (0) or the
/// vertical (90).
Vec3 off_axis(PhotometricType type, double degrees, double plane);

} // namespace keiko
