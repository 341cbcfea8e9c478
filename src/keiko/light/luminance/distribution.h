#pragma once

namespace keiko {

/// Distribution of the reflected light of a glossy surface (docs/theory/luminance.md#lobes). The
/// `width` of each is its parameter as the papers write it.
enum class DistributionKind {
    phong,            ///< n: cos^n of the angle to the mirror direction
    blinn,            ///< n: cos^n of the angle between normal and half vector
    gauss,            ///< m: exp(-(alpha / m)^2)
    trowbridge_reitz, ///< c: ellipsoids, the GGX of later papers
    beckmann          ///< m: rms slope, as in [CookTorrance1982]
};

/// A distribution with its parameter, above 0.
class Distribution {
public:
    Distribution(DistributionKind kind, double width);

    DistributionKind kind() const { return kind_; }
    double width() const { return width_; }
    /// Whether it is one of half vectors; Phong's is of directions about the mirror direction.
    bool of_half_vectors() const { return kind_ != DistributionKind::phong; }

    /// 1/sr, from the cosine and the squared sine of alpha, the angle of the half vector to the
    /// normal, or of the direction to the mirror direction. Its integral over the hemisphere, times
    /// cos alpha for half vectors, is 1; 0 where the cosine is not positive.
    double density(double cosine, double sine2) const;

    /// Angle in radians within which about two thirds of the light lie, seen from the surface: for
    /// half vectors twice that of alpha.
    double spread() const;
    /// Half angle in radians of the cone about the mirror direction outside of which the density is
    /// below `share` of its peak; pi where there is none.
    double cone(double share) const;

private:
    DistributionKind kind_;
    double width_;
    double scale_; ///< density at alpha = 0
};

} // namespace keiko
