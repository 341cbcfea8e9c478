#pragma once

#include "keiko/maps/low_order_light.h"
#include "keiko/maps/picture_texture.h"
#include "keiko/scene/environment_spec.h"

#include <optional>
#include <vector>

namespace keiko {

/// Surroundings at infinity by a picture.
class Environment {
public:
    /// Reads the picture. Throws Error.
    explicit Environment(const EnvironmentSpec& spec);

    /// cd/m2 from a direction of any length but 0 that changes by `dx` and `dy` across the pixel.
    Rgb luminance(const Vec3& direction, const Vec3& dx = Vec3(0), const Vec3& dy = Vec3(0)) const;
    /// cd/m2 in the mean over a square of directions, `width` rad a side, about a unit one.
    Rgb blurred(const Vec3& direction, double width) const;
    /// lx on a surface with a unit normal, by its low orders.
    Rgb irradiance(const Vec3& normal) const;
    /// lx on a surface with a unit normal, by the sum over all texels of the picture.
    Rgb texel_irradiance(const Vec3& normal) const;
    /// The largest deviation of irradiance() from texel_irradiance() over 26 directions, relative
    /// to the largest there.
    double low_order_error() const;

    /// Specification that it was made of.
    const EnvironmentSpec& spec() const { return spec_; }

private:
    template <class Visit>
    void each_texel(const Visit& visit) const;
    Vec3 to_world(const Vec3& direction) const;
    Vec3 to_picture(const Vec3& direction) const;

    EnvironmentSpec spec_;
    double cosine_, sine_;              ///< of the azimuth
    std::vector<PictureTexture> faces_; ///< one, or six
    LowOrderLight low_orders_;
};

} // namespace keiko
