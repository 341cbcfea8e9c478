#include "keiko/files/photometric/luminaire_file.h"

#include "keiko/base/input_file.h"

#include <algorithm>

namespace keiko {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
    std::string text = path.extension().string();
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
}

} // namespace

bool is_luminaire_file(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    return extension == ".ies" || extension == ".ldt";
}

PhotometricWeb read_luminaire(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    return lower_extension(path) == ".ldt" ? parse_eulumdat(text, path) : parse_ies(text, path);
}

} // namespace keiko
