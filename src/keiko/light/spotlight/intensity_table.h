#pragma once

#include <vector>

namespace keiko {

/// Interpolation of a table between its vertical angles [NishitaSpots, eq. 7 and 8]; between its
/// planes it is always linear in the angle.
enum class TableInterpolation {
    linear, ///< in the angle
    cosine  ///< in its cosine: flat on the axis, as a symmetric lamp is
};

/// Symmetry by which the planes of a table stand for others
/// (docs/theory/spotlights.md#luminaire-files).
enum class PlaneSymmetry {
    none,             ///< the planes go all the way round
    axial,            ///< one plane for all
    quadrant,         ///< 0 to 90 degrees, mirrored at both
    bilateral,        ///< 0 to 180 degrees, mirrored there
    bilateral_across, ///< 90 to 270 degrees, mirrored there
    lateral,          ///< 0 and up for both signs of the angle
    limited           ///< dark outside of the planes
};

/// Intensities over a grid of two angles in degrees, V (from the axis, or the elevation) and H
/// (about the axis, or the azimuth): the one look-up of tables in scenes and of luminaire files.
class IntensityTable {
public:
    /// `values`: plane by plane of `horizontal`, V fastest. Requires ascending angles, at least one
    /// of each, and as many values as both have together; with PlaneSymmetry::none the planes of
    /// 0 to below 360 degrees, or up to 360.
    IntensityTable(std::vector<double> vertical, std::vector<double> horizontal,
                   std::vector<double> values, PlaneSymmetry symmetry,
                   TableInterpolation interpolation = TableInterpolation::linear);

    /// Intensity under angles in degrees; 0 outside of the vertical angles, and of the planes where
    /// these are limited or lateral.
    double operator()(double vertical, double horizontal) const;

    const std::vector<double>& vertical() const { return vertical_; }
    const std::vector<double>& horizontal() const { return horizontal_; }
    /// Of plane `h` at vertical angle `v`, both by number.
    double value(std::size_t h, std::size_t v) const { return values_[h * vertical_.size() + v]; }
    PlaneSymmetry symmetry() const { return symmetry_; }
    TableInterpolation interpolation() const { return interpolation_; }
    double largest() const;
    /// The largest vertical angle that is not dark in every plane, and beyond which all is; the
    /// next one where a value leads there. 0 where all is dark.
    double lit_up_to() const;

    bool operator==(const IntensityTable&) const = default;

private:
    double folded(double horizontal) const;

    std::vector<double> vertical_, horizontal_, values_;
    PlaneSymmetry symmetry_;
    TableInterpolation interpolation_;
};

} // namespace keiko
