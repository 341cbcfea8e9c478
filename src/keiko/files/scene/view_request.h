#pragma once

#include "keiko/base/export.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/scene/analysis.h"
#include "keiko/scene/camera.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// A page's request to an open scene: the view, and the lamps.
struct ViewRequest {
    std::optional<Camera> camera{};              ///< none: the view that was opened
    std::optional<std::vector<CPlane>> planes{}; ///< none: those of the rig; else in place of them
    bool interlaced = true;                      ///< rows from coarse to fine, see interlaced_rows
    int reflections = 3;                         ///< of a deep buffer, 1 to 8
    std::vector<std::uint32_t> hidden{};         ///< faces that are not shown, as Face::id
    std::optional<Vec2> pixel{};                 ///< of the camera's picture, that is picked
    std::optional<double> ev{};                  ///< exposure of a still; none: by the picture
    std::vector<AnalysisView> views{};           ///< of an analysis that is to be kept
    std::vector<std::string> sections{};         ///< of it, planes such as "y=120"
    std::vector<AnalysisNote> notes{};           ///< of it
};

/// Parses a request (keiko-view-request/1, docs/file-formats.md). An empty text requests the view
/// as it was opened. A text that names a file is refused. Throws Error with line and column.
ViewRequest parse_view_request(std::string_view text);

/// The rig with other rows of lamps, in the order of its own; further ones follow, and those that
/// are left over go. Other lights and the medium stay.
LightRig with_planes(const LightRig& rig, const std::vector<CPlane>& planes);

} // namespace keiko
