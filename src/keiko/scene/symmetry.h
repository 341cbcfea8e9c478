#pragma once

#include "keiko/base/export.h"
#include "keiko/math/affine.h"

#include <optional>
#include <string>
#include <string_view>

namespace KEIKO_API keiko {

/// A plane across one of the axes, that a body may be symmetric about.
struct MirrorPlane {
    int axis = 1;      ///< 0 to 2: x, y, z
    double offset = 0; ///< mm along it

    /// "y" or "y=12.5"; throws Error for anything else.
    static MirrorPlane parse(std::string_view text);
    /// "y = 12.5"
    std::string text() const;
    /// The reflection.
    Affine motion() const;
    /// The image of a point, and of a direction.
    Vec3 image(const Vec3& point) const;
    /// Image of a direction, which only turns.
    Vec3 image_of_direction(const Vec3& direction) const;
    /// Signed mm from the plane.
    double distance(const Vec3& point) const { return point[axis] - offset; }

    bool operator==(const MirrorPlane&) const = default;
};

/// Limit of a body's distance from its own mirror image.
struct SymmetryLimit {
    MirrorPlane plane;      ///< plane of the mirror image
    double distance = 0.01; ///< mm, from any place of the surface to the image

    bool operator==(const SymmetryLimit&) const = default;
};

/// Choice of the plane of symmetry of a body.
struct SymmetryChoice {
    /// Way to choose the plane.
    enum class Kind {
        automatic, ///< a plane that is found
        off,       ///< none
        plane      ///< `plane`
    };
    Kind kind = Kind::off;                      ///< none unless stated
    MirrorPlane plane{};                        ///< of Kind::plane
    double distance = SymmetryLimit{}.distance; ///< mm from its image up to which it is symmetric

    /// "auto", "off" or a plane as MirrorPlane has it; throws Error for anything else.
    static SymmetryChoice parse(std::string_view text);
};

} // namespace keiko
