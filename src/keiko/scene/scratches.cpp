#include "keiko/scene/scratches.h"

namespace keiko {
namespace {

struct DirectionAt {
    const Vec3 &place, &du, &dv;

    Vec3 operator()(FaceDirection direction) const {
        return direction == FaceDirection::u ? du : dv;
    }
    Vec3 operator()(const SpaceDirection& along) const { return along.direction; }
    Vec3 operator()(const AroundAxis& around) const {
        return around.axis.cross(place - around.point);
    }
};

struct Moved {
    const Affine& motion;

    ScratchDirection operator()(FaceDirection direction) const { return direction; }
    ScratchDirection operator()(const SpaceDirection& along) const {
        return SpaceDirection{motion.vector(along.direction)};
    }
    ScratchDirection operator()(const AroundAxis& around) const {
        return AroundAxis{motion.point(around.point), motion.vector(around.axis)};
    }
};

} // namespace

Vec3 direction_at(const ScratchDirection& scratches, const Vec3& place, const Vec3& du,
                  const Vec3& dv) {
    return std::visit(DirectionAt{place, du, dv}, scratches);
}

ScratchDirection moved(const Affine& motion, const ScratchDirection& scratches) {
    return std::visit(Moved{motion}, scratches);
}

} // namespace keiko
