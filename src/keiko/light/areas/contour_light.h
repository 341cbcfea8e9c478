#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/affine.h"
#include "keiko/math/bounds.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <memory>
#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// A closed body, or several, that shines outwards all over: the questions that its light asks of
/// its surface. Immutable; may be asked from any thread.
class LuminousBody {
public:
    virtual ~LuminousBody() = default;
    /// Box around it, world, mm.
    virtual const Box3& bounds() const = 0;
    /// Visibility from a point outside with nothing but the body between. `region`: corners of a
    /// convex body that holds all queried segments. Refers to this body; for one thread.
    virtual std::unique_ptr<Visibility> outline_from(const Vec3& point,
                                                     std::vector<Vec3> region) const = 0;
    /// Distance, in lengths of `direction`, at which a ray meets it; nullopt if it does not.
    virtual std::optional<double> distance(const Vec3& origin, const Vec3& direction) const = 0;
    /// True for a point inside.
    virtual bool contains(const Vec3& point) const = 0;
    /// Place just in front of the body for one on it with the unit `normal`; any other as it is.
    virtual Vec3 in_front(const Vec3& point, const Vec3& normal) const = 0;
    /// The body moved.
    virtual std::shared_ptr<const LuminousBody> moved(const Affine& motion) const = 0;
};

/// A luminous body of uniform luminance in all directions: what is visible of it lights by its
/// contour alone. Cameras and mirrors show the body itself.
struct ContourLight {
    std::shared_ptr<const LuminousBody> body; ///< never null
    Rgb luminance{10000};                     ///< cd/m2, colour included

    bool operator==(const ContourLight&) const = default;
};

} // namespace keiko
