#pragma once

#include "keiko/inspect/joints/joint.h"
#include "keiko/inspect/joints/panel_borders.h"
#include "keiko/scene/joint_limits.h"

#include <optional>

namespace keiko {

/// Result of looking for a panel across the gap from a place of another one's border.
struct AcrossResult {
    std::optional<JointSection> section; ///< nullopt: nothing, or nothing that can be measured
    std::size_t body = 0;                ///< the other body, if `section` or `is_unmeasured`
    bool is_unmeasured = false;          ///< a panel lies there, but its section was lost
};

/// Measures the section at parameter `t` of a border towards the nearest edge of another body.
AcrossResult measure_across(const PanelBorders& borders, const PanelBorder& border, double t,
                            const JointLimits& limits);

} // namespace keiko
