#pragma once

#include "net.h"

#include <filesystem>

namespace keiko::fixtures {

/// Writes Bezier patches as .bpt, coordinates in mm with all digits.
void write_bpt(const std::filesystem::path& file, const std::vector<Net>& patches);

} // namespace keiko::fixtures
