#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/math/bounds.h"
#include "keiko/scene/camera.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Names of the views in the vehicle frame: x rearwards, y to the right, z up.
///
/// The views front, rear, left and right are level, from that side; "left" is the driver's left.
/// Those of three-quarter-front and three-quarter-rear, with -left or -right (left when not
/// stated), are from 15 degrees above the horizon. The views high-* are the same eight from 40
/// degrees above it. In top the front of the car is to the left of the picture, in bottom to the
/// right. The views standing-* are the same eight as a walking surfacer has them. Their eye is 1650
/// mm above the ground, 3 to 5 m from the body, farther where it is too large. The ground is that
/// of the framing. Without one it is z = 0 for a body that is above it and reaches below the eye,
/// as a panel in the coordinates of its vehicle is, and else the body's lowest z.
const std::vector<std::string>& view_names();

/// Framing of a named view.
struct Framing {
    int width = 960, height = 540;  ///< pixels
    double vertical_fov = 28;       ///< degrees; standing views choose their own
    double margin = 0.04;           ///< share of the picture left free at each border
    std::optional<double> ground{}; ///< mm, z of the floor to stand on; none: see view_names
};

/// The perspective camera of a named view that has the whole box in the picture and fills its
/// width or height. Throws Error for an unknown name, naming the known ones, and for an empty box.
Camera frame_view(std::string_view name, const Box3& bounds, const Framing& framing = {});

/// Perspective camera like that of frame_view(), for an eye in any direction from the box. Throws
/// Error for an empty box.
Camera frame_direction(const Vec3& towards_eye, const Box3& bounds, const Framing& framing = {});

/// Remark on a body that plainly does not lie in the vehicle frame, which named views assume. The
/// box of such a body is symmetric about x = 0 or z = 0 alone, not about y = 0, the middle plane of
/// a vehicle. It reaches farther to y > 0 than to y < 0, as a body does that stands on y = 0. The
/// entity is the option `axes` (see LoadOptions), and the message suggests one. nullopt for any
/// other box, e.g. those of panels, of half bodies and of bodies that are symmetric about two
/// planes.
std::optional<Diagnostic> axes_remark(const Box3& body);

} // namespace keiko
