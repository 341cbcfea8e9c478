#pragma once

#include <filesystem>

namespace keiko::test {

/// Whether OpenCASCADE finds that every face of a CAD file is part of a closed shell.
bool closed_by_opencascade(const std::filesystem::path& file);

} // namespace keiko::test
