#pragma once

#include "keiko/math/bounds.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/symmetry.h"

#include <span>

namespace keiko {

/// Whether a plane for lamps is its own mirror image, with u and v along the mirror or square to
/// it.
bool is_own_image(const PlaneFrame& frame, const MirrorPlane& mirror);
/// The image of a frame.
PlaneFrame image_of(const PlaneFrame& frame, const MirrorPlane& mirror);
/// The smallest rectangle that holds another, on a frame that is its own image, and is one too.
Box2 symmetric_extent(const PlaneFrame& frame, const Box2& extent, const MirrorPlane& mirror);

/// Whether a camera's picture is its own mirror image where what it sees is: its eye lies on the
/// mirror, and so do its axes but one.
bool is_own_image(const Camera& camera, const MirrorPlane& mirror);

} // namespace keiko
