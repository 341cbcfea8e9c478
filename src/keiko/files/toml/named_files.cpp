#include "keiko/files/toml/named_files.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/files/toml/toml_guard.h"

#include <toml++/toml.h>

#include <set>

namespace keiko {
namespace fs = std::filesystem;
namespace {

void collect_texts(const toml::node& node, std::vector<std::string>& texts) {
    if (const auto* text = node.as_string()) texts.push_back(text->get());
    if (const auto* array = node.as_array())
        for (const toml::node& element : *array) collect_texts(element, texts);
    if (const auto* table = node.as_table())
        for (const auto& [key, element] : *table) collect_texts(element, texts);
}

std::vector<std::string> texts_of(const fs::path& file) {
    const std::string content = read_file(file);
    require_parsable_toml(content, file.string());
    std::vector<std::string> texts;
    try {
        collect_texts(toml::parse(content, file.string()), texts);
    } catch (const toml::parse_error& error) {
        throw Error(file.string(), std::to_string(error.source().begin.line),
                    shortened(error.description()));
    }
    return texts;
}

void follow(const fs::path& file, std::set<fs::path>& found) {
    if (!found.insert(file).second || file.extension() != ".toml") return;
    for (const std::string& text : texts_of(file)) {
        if (text.find('\0') != std::string::npos) continue; // the name of no file
        const fs::path named = (file.parent_path() / text).lexically_normal();
        std::error_code no_file;
        if (fs::is_regular_file(named, no_file)) follow(named, found);
    }
}

} // namespace

std::vector<fs::path> files_named_by(const fs::path& toml_file) {
    std::set<fs::path> found;
    follow(toml_file.lexically_normal(), found);
    return {found.begin(), found.end()};
}

} // namespace keiko
