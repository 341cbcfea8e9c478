#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace keiko {

/// Line and column of a file, both counted from 1.
struct TomlPlace {
    std::uint32_t line = 0, column = 0;

    auto operator<=>(const TomlPlace&) const = default;
    /// "line:column".
    std::string text() const { return std::to_string(line) + ":" + std::to_string(column); }
};

struct TomlEntry;

/// A value of a file. monostate: a kind that no format of Keiko uses (dates).
struct TomlValue {
    std::variant<std::monostate, double, std::int64_t, std::string, std::vector<TomlValue>,
                 std::vector<TomlEntry>, bool>
        content;
    TomlPlace place;

    /// "number", "text", "array", "table", "flag" or "other".
    std::string_view kind() const {
        static constexpr std::string_view kinds[] = {"other", "number", "number", "text",
                                                     "array", "table",  "flag"};
        return kinds[content.index()];
    }
};

/// A key of a table with its value.
struct TomlEntry {
    std::string key;
    TomlPlace place; ///< of the key
    TomlValue value;
};

/// A file: what it is called, and its root table.
struct TomlDocument {
    std::filesystem::path source;
    TomlValue root;
};

/// Throws Error with `source`, line and column for a text that is no TOML.
TomlDocument parse_toml(std::string_view text, const std::string& source);

/// A TOML file and every file that it names, sorted, each once. A text names a file if it is the
/// path of a regular file relative to the folder of the TOML file. TOML files named so are followed
/// too. The list is a superset of what reading the file takes, whatever its format. Throws Error
/// for a file that cannot be parsed.
std::vector<std::filesystem::path> files_named_by(const std::filesystem::path& toml_file);

} // namespace keiko
