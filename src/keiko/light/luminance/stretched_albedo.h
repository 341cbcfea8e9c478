#pragma once

#include "keiko/light/luminance/clear_coat.h"

#include <array>
#include <memory>

namespace keiko {

/// Directional albedos of a stretched lobe, tabulated by the cosine and by the azimuth of the
/// viewer from the scratches.
class StretchedAlbedo {
public:
    /// Tabulates directional_albedo() at seven azimuths, by a rule over the facets.
    explicit StretchedAlbedo(const Gloss& gloss);

    /// Albedo of a viewer under `cosine`, to about 1e-3. `doubled`, -1 to 1, is the cosine of twice
    /// the azimuth: 1 along the scratches, -1 across them.
    Rgb operator()(double cosine, double doubled) const;
    /// Mean over the azimuths, by the cosine.
    std::shared_ptr<const AlbedoTable> mean() const { return mean_; }

private:
    /// Width of the lobe towards an azimuth, in which the albedo is smooth, by `doubled`.
    double width_at(double doubled) const;

    static constexpr std::size_t count = 7;
    double along2_, across2_; ///< squares of the lobe's widths
    /// At the azimuths towards which the width is at Chebyshev's points between both.
    std::array<std::shared_ptr<const AlbedoTable>, count> tables_;
    std::shared_ptr<const AlbedoTable> mean_;
};

/// Cosine of twice the azimuth of the viewer from the scratches, both projected to the surface of
/// the unit `normal`; 0 where one of them is along it.
double doubled_azimuth_cosine(const Vec3& normal, const Vec3& eye, const Vec3& along);

} // namespace keiko
