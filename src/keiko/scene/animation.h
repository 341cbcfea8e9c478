#pragma once

#include <optional>
#include <string>
#include <vector>

namespace keiko {

struct SceneSpec;

/// What a number, or three, of a scene are at a frame.
struct KeyFrame {
    double frame = 0;
    std::vector<double> value;

    bool operator==(const KeyFrame&) const = default;
};

/// How a part of a scene moves: between key frames in a straight line, before the first and after
/// the last not at all.
struct Animation {
    /// Its place in the scene, as its file names it, tables that repeat with their number from 0:
    /// "spotlight.0.aim".
    std::string target;
    std::vector<KeyFrame> keys; ///< rising, at least one

    /// The value at a frame.
    std::vector<double> at(double frame) const;

    bool operator==(const Animation&) const = default;
};

/// What is wrong with an animation.
struct AnimationFault {
    std::string key; ///< of a scene file's table: "target" or "keys"
    std::string what;
};

/// Why the scene cannot be animated so; nothing when it can: the target must be there and be one
/// that moves, and every value have as many numbers as it, one being enough for a colour, within
/// what the target may be. A direction must be one at each key and between them.
std::optional<AnimationFault> animation_fault(SceneSpec& scene, const Animation& animation);

/// The scene as it is at a frame. Throws Error where no picture can be made of it: an eye in its
/// target, a lamp in its aim, light without a direction.
SceneSpec at_frame(SceneSpec scene, double frame);

} // namespace keiko
