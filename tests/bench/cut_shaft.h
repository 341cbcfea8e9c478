#pragma once

#include <filesystem>

namespace keiko::bench {

/// Draws the scene surfaces/cut-shaft-scene.toml as a PNG, and on it one camera ray that runs
/// through its shaft. Drawn as well: the parts of the ray that the lamp sees, and the ways from the
/// lamp to their ends, which graze the bodies.
void draw_cut_shaft(const std::filesystem::path& output);

} // namespace keiko::bench
