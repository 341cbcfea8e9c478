#pragma once

#include "keiko/base/export.h"
#include "keiko/workflow/open_scene.h"

#include <cstdint>
#include <optional>
#include <span>

namespace KEIKO_API keiko {

/// Throws FieldError for an id that no face of a model has.
void require_faces(const SurfaceModel& model, std::span<const std::uint32_t> ids);

/// Tracer of the scene's pictures without some faces of its body, by Face::id. What they hid comes
/// to light, and is mirrored. Nothing is built or copied; see Tracer::without. Throws FieldError
/// for an id that no face has.
Tracer seen_without(const Scene& scene, std::span<const std::uint32_t> ids);

/// Occluders of the scene's pictures without some faces, prepared anew. nullopt unless the scene
/// casts shadows. Throws as seen_without, and Cancelled.
std::optional<Occluders> occluders_without(const Scene& scene, std::span<const std::uint32_t> ids,
                                           const Job& job = {});

/// The scene without some faces of its body, for pictures and numbers. They keep their places in
/// the lists of faces and materials, and have no patches. The ground is that of the whole body.
/// Throws as occluders_without.
Scene without_faces(const Scene& scene, std::span<const std::uint32_t> ids, const Job& job = {});

/// The scene without the faces that its analysis hides; nullopt if it hides none. Throws Cancelled.
std::optional<Scene> without_hidden_faces(const Scene& scene, const Job& job = {});

} // namespace keiko
