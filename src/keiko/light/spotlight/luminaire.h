#pragma once

#include "keiko/base/export.h"
#include "keiko/light/spotlight/beam_direction.h"
#include "keiko/light/spotlight/photometric_web.h"
#include "keiko/math/rgb.h"

#include <memory>
#include <string>

namespace KEIKO_API keiko {

/// A placed luminaire of a file; without extent.
struct Luminaire {
    std::string file{};                          ///< IES LM-63 or EULUMDAT
    std::shared_ptr<const PhotometricWeb> web{}; ///< contents of the file
    Vec3 position{0};                            ///< mm
    Vec3 aim{0, 0, -1}; ///< mm, a point on the axis of the file's angles (see web_axis)
    /// Direction of H = 0, or of up for type A; of any length, its part along the axis is dropped.
    Vec3 reference{1, 0, 0};
    double spin = 0;     ///< degrees by which H = 0 is turned about the axis, towards rising H
    bool flip_h = false; ///< H runs in the opposite direction, as some tools write it
    Rgb factor{1};       ///< multiplies the file's intensities: dimming and colour
    bool shaft = true;   ///< it lights the medium
};

/// Intensity of a luminaire, prepared for many points; keeps a reference to it. The luminaire must
/// have a web.
class LuminaireIntensity {
public:
    /// Intensity of a luminaire, which must outlive it.
    explicit LuminaireIntensity(const Luminaire& luminaire);

    /// cd towards a point in mm; 0 at the luminaire itself.
    Rgb operator()(const Vec3& point) const;
    /// Frame of the file's angles: `axis` is the axis that they turn about, phi = 0 and 90 are the
    /// angles of its planes.
    BeamFrame frame() const;
    /// A direction of the world in the luminaire's own frame.
    Vec3 own(const Vec3& direction) const {
        return {direction.dot(x_), direction.dot(y_), direction.dot(z_)};
    }

private:
    const Luminaire& luminaire_;
    Vec3 x_{0}, y_{0}, z_{0}; ///< of the luminaire's own frame in the world
};

/// Intensity in cd towards a point in mm; 0 at the luminaire itself.
Rgb intensity_towards(const Luminaire& luminaire, const Vec3& point);

} // namespace keiko
