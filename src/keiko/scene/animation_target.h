#pragma once

#include <limits>
#include <string>
#include <vector>

namespace keiko {

struct SceneSpec;

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

} // namespace keiko
