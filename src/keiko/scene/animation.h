#pragma once

#include "keiko/math/vec.h"
#include "keiko/scene/scene_spec.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keiko {

// The numbers of a scene that move, and the scene as it is at a frame.

/// Numbers of a scene that move, and between what they may lie.
struct MovingNumbers {
    /// Meaning of the first three numbers.
    enum class Kind {
        plain,    ///< each by itself
        color,    ///< one number may stand for all three
        direction ///< must not all be 0, nor become their opposite on a straight way
    };

    std::vector<double*> places{}; ///< one to four numbers of the scene, none null; or none
    double low = -std::numeric_limits<double>::infinity(); ///< least that each may be
    double high = -low;                                    ///< most that each may be
    Kind kind = Kind::plain;                               ///< of the first three
};

/// Numbers that a target names, such as "spotlight.0.aim"; no places where the scene has nothing
/// there that moves. Points into the scene.
MovingNumbers numbers_of(SceneSpec& scene, const std::string& name);

/// " (did you mean ...?)" for a target that the scene does not have, or "".
std::string suggested_target(SceneSpec& scene, const std::string& name);

/// Unit direction of phi = 0 of a lamp whose axis has turned through `ways`, from one to the next
/// in a plane. Parallel transport carries it along (docs/theory/spotlights.md#moving-axes), so that
/// the pattern does not flip where the axis passes `reference`. `ways`: at least one, none of no
/// length.
Vec3 carried_reference(const Vec3& reference, std::span<const Vec3> ways);

/// Fault of an animation.
struct AnimationFault {
    std::string key;  ///< of a scene file's table: "target" or "keys"
    std::string what; ///< is wrong: words for the user
};

/// Reason why the scene cannot be animated so; nullopt when it can. The target must be there and be
/// one that moves. Every value must have as many numbers as it, one being enough for a colour,
/// within what the target may be. A direction must be one at each key and between them.
std::optional<AnimationFault> animation_fault(SceneSpec& scene, const Animation& animation);

/// The scene as it is at a frame. Throws Error where no picture can be made of it: an eye in its
/// target, a lamp in its aim, light without a direction.
SceneSpec at_frame(SceneSpec scene, double frame);

} // namespace keiko
