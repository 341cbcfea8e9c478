#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace keiko::fixtures {

void write_lines(const std::filesystem::path& file, const std::vector<std::string>& lines);

void write_bytes(const std::filesystem::path& file, const std::string& bytes);

} // namespace keiko::fixtures
