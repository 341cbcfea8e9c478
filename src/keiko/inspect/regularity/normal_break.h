#pragma once

#include "keiko/inspect/regularity/normal_patch.h"

#include <functional>

namespace keiko {

/// Predicate that is true if a place of a patch, in its own parameters, is material.
using IsMaterial = std::function<bool(const Vec2&)>;

/// A place about which the normals have no limit.
struct NormalBreak {
    double angle = 0; ///< degrees between two normals, in the limit at the place
    /// True if the normal stays on its side for the negligible length on both sides of the place.
    bool turns_over = false;
    /// True if both of these parts are as wide as that square to their length, too.
    bool wide = false;
    Vec3 place{0}; ///< world, mm
};

/// The place between two others of a box of parameters at which the normal turns over: by more than
/// 175 degrees on a path of `near` mm. It is searched by bisection along the straight path in the
/// parameters, so that normals that turn uniformly, however far, give nullopt. The normal must turn
/// over on a second path beside it too: at a single singular place it does on one alone.
std::optional<NormalBreak> turn_between(const NormalPatch& patch, const std::array<Vec2, 2>& ends,
                                        const Box2& box, double near,
                                        const IsMaterial& is_material);

/// The break of the normals about the place at which |S_u x S_v| is least in three times a box of
/// parameters. Normals are compared at places around it, as wide as those boxes and a quarter of
/// it: those of a smooth surface differ in proportion. It is nullopt if the limit, extrapolated, is
/// less than a third of the difference.
std::optional<NormalBreak> break_about(const NormalPatch& patch, const Box2& box, double near,
                                       const IsMaterial& is_material);

} // namespace keiko
