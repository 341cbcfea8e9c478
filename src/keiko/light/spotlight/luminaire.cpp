#include "keiko/light/spotlight/luminaire.h"

#include "keiko/base/units.h"

namespace keiko {

LuminaireIntensity::LuminaireIntensity(const Luminaire& luminaire) : luminaire_(luminaire) {
    const BeamFrame frame = beam_frame(luminaire.aim - luminaire.position, luminaire.reference,
                                       degrees_to_radians(luminaire.spin));
    if (luminaire.web->type == PhotometricType::a)
        x_ = frame.axis, z_ = frame.across;
    else
        x_ = frame.across, z_ = -frame.axis;
    y_ = z_.cross(x_) * (luminaire.flip_h ? -1.0 : 1.0);
}

Rgb LuminaireIntensity::operator()(const Vec3& point) const {
    const Vec3 way = point - luminaire_.position;
    const double distance = way.length();
    if (!(distance > 0)) return {};
    return luminaire_.factor * intensity(*luminaire_.web, own(way / distance));
}

BeamFrame LuminaireIntensity::frame() const {
    switch (luminaire_.web->type) {
        case PhotometricType::a:
            return {z_, x_, -y_};
        case PhotometricType::b:
            return {y_, -z_, x_};
        case PhotometricType::c:
            break;
    }
    return {-z_, x_, y_};
}

Rgb intensity_towards(const Luminaire& luminaire, const Vec3& point) {
    return LuminaireIntensity(luminaire)(point);
}

} // namespace keiko
