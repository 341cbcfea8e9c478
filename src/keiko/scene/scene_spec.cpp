#include "keiko/scene/scene_spec.h"

#include "keiko/base/units.h"

namespace keiko {

Affine ModelTransform::affine() const {
    return Affine::translate(translation) * Affine::rotate(axis, degrees_to_radians(angle)) *
           Affine::scale(scale);
}

} // namespace keiko
