#pragma once

#include "fixture.h"

#include <filesystem>

namespace keiko::fixtures {

/// Writes a cage as OBJ with OpenSubdiv's tags, coordinates in mm with all digits.
void write_obj(const std::filesystem::path& file, const CageFixture& cage);

} // namespace keiko::fixtures
