#pragma once

#include "keiko/base/export.h"
#include "keiko/render/deep_buffer.h"
#include "keiko/report/content/view_facts.h"
#include "keiko/workflow/open_scene.h"

#include <string>

namespace KEIKO_API keiko {

/// The deep buffer of a view of a scene: that of the body and its ground. The face of samples on
/// the ground is -1. Throws FieldError for rows or reflections out of range, and Cancelled.
DeepBuffer deep_view(const Scene& scene, const Camera& camera, const DeepOptions& options = {},
                     const Job& job = {});

/// The deep buffer of a part of a scene; `seen` is the tracer of that part, see seen_without.
DeepBuffer deep_view(const Scene& scene, const Tracer& seen, const Camera& camera,
                     const DeepOptions& options = {}, const Job& job = {});

/// Facts of a scene that a viewer needs beside its deep buffers, if it is opened with a view.
ViewFacts view_facts(const Scene& scene, const NamedView& view);

/// A deep buffer as bytes, "keiko-deep/1" of docs/file-formats.md. Several of the same picture may
/// follow each other.
std::string deep_bytes(const DeepBuffer& buffer);

} // namespace keiko
