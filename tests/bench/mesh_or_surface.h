#pragma once

#include <filesystem>

namespace keiko::bench {

/// Writes the picture of docs/benchmarks.md: the same close-up of stripes on the hood from a mesh
/// of 0.1 mm, one of 0.01 mm and from Keiko, side by side. Throws Error.
void draw_mesh_or_surface(const std::filesystem::path& output);

} // namespace keiko::bench
