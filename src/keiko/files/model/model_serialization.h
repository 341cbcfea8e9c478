#pragma once

#include "keiko/base/export.h"
#include "keiko/files/model/byte_stream.h"
#include "keiko/geometry/model/surface_model.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace KEIKO_API keiko {

/// Rises with every change of what is written.
constexpr std::uint32_t model_serialization_version = 3;

/// Hands a model on as bytes, the same bytes for the same model: docs/model-serialization.md. A
/// large one never lies in memory as bytes.
void serialize(const SurfaceModel& model, const TakeBytes& sink);
/// Serialised bytes of a model in one piece.
std::string serialize(const SurfaceModel& model);

/// The model in `bytes`. Throws Error naming `file` when they are damaged, cut short, of another
/// version, or hold indices, degrees or numbers that no model can have: whatever comes back may
/// be used without further checks.
SurfaceModel deserialize(std::string_view bytes, const std::string& file);

/// First structural fault of a model; nullopt for a sound one. Faults are an index out of range, a
/// degree out of 1..max_degree, a number that is not finite, and a weight that is not positive.
std::optional<std::string> structural_fault(const SurfaceModel& model);

} // namespace keiko
