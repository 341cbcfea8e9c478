#pragma once

#include <limits>
#include <string>
#include <vector>

namespace keiko {

struct SceneSpec;

/// Numbers of a scene that move, and between what they may lie.
struct MovingNumbers {
    std::vector<double*> places{};
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    enum class Kind { plain, color, direction } kind = Kind::plain; ///< of the first three
};

/// Numbers that a target names, such as "spotlight.0.aim"; no places where the scene has nothing
/// there that moves. Points into the scene.
MovingNumbers numbers_of(SceneSpec& scene, const std::string& name);

/// " (did you mean ...?)" for a target that the scene does not have, or "".
std::string suggested_target(SceneSpec& scene, const std::string& name);

} // namespace keiko
