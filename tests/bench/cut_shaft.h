#pragma once

#include <filesystem>

namespace keiko::bench {

/// The scene surfaces/cut-shaft-scene.toml as a PNG, and on it one camera ray that runs through its
/// shaft: the parts that the lamp sees, and the ways from the lamp to their ends, which graze the
/// bodies.
void draw_cut_shaft(const std::filesystem::path& output);

} // namespace keiko::bench
