#include "text_file.h"

#include <fstream>
#include <stdexcept>

namespace keiko::fixtures {

void write_lines(const std::filesystem::path& file, const std::vector<std::string>& lines) {
    std::ofstream out(file, std::ios::binary);
    for (const std::string& line : lines) out << line << '\n';
    if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

} // namespace keiko::fixtures
