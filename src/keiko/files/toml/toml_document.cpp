#include "keiko/files/toml/toml_document.h"

#include "keiko/base/error.h"
#include "keiko/files/toml/toml_guard.h"

#include <toml++/toml.h>

namespace keiko {
namespace {

TomlPlace place_of(const toml::source_region& region) {
    return {region.begin.line, region.begin.column};
}

TomlValue value_of(const toml::node& node) {
    TomlValue value;
    value.place = place_of(node.source());
    if (const auto* real = node.as_floating_point()) value.content = real->get();
    if (const auto* whole = node.as_integer()) value.content = whole->get();
    if (const auto* text = node.as_string()) value.content = text->get();
    if (const auto* flag = node.as_boolean()) value.content = flag->get();
    if (const auto* array = node.as_array()) {
        std::vector<TomlValue> values;
        for (const toml::node& element : *array) values.push_back(value_of(element));
        value.content = std::move(values);
    }
    if (const auto* table = node.as_table()) {
        std::vector<TomlEntry> entries;
        for (const auto& [key, element] : *table)
            entries.push_back({std::string(key.str()), place_of(key.source()), value_of(element)});
        value.content = std::move(entries);
    }
    return value;
}

} // namespace

TomlDocument parse_toml(std::string_view text, const std::string& source) {
    require_parsable_toml(text, source);
    try {
        const toml::table root = toml::parse(text, source);
        return {source, value_of(root)};
    } catch (const toml::parse_error& error) {
        throw Error(source, place_of(error.source()).text(), shortened(error.description()));
    }
}

} // namespace keiko
