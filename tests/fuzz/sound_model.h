#pragma once

#include "keiko/files/model/model_serialization.h"

#include "tests/fuzz/fuzz_target.h"

namespace keiko::fuzz {

/// Checks what every reader of models promises: code that gets one need not check it again, and it
/// travels between processes without loss.
inline void require_sound(const SurfaceModel& model) {
    if (const auto fault = structural_fault(model)) require(false, fault->c_str());
    const std::string bytes = serialize(model);
    require(serialize(deserialize(bytes, "")) == bytes, "a model reads back as it was written");
}

} // namespace keiko::fuzz
