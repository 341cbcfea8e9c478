#pragma once

#include "keiko/base/export.h"
#include "keiko/workflow/open_scene.h"

#include <cstdint>
#include <optional>
#include <span>

namespace KEIKO_API keiko {

/// Throws FieldError for an id that no face of a model has.
void require_faces(const SurfaceModel& model, std::span<const std::uint32_t> ids);

/// The scene without some faces of its body, by Face::id. They keep their places in the lists of
/// faces and materials, and have no patches; what they hid comes to light. Throws FieldError for an
/// id that no face has, and Cancelled.
Scene without_faces(const Scene& scene, std::span<const std::uint32_t> ids, const Job& job = {});

/// The scene without the faces that its analysis hides; nullopt if it hides none. Throws Cancelled.
std::optional<Scene> without_hidden_faces(const Scene& scene, const Job& job = {});

} // namespace keiko
