#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace keiko {

/// Line and column of a file, both counted from 1.
struct TomlPlace {
    std::uint32_t line = 0;   ///< from 1
    std::uint32_t column = 0; ///< from 1

    // NOLINTNEXTLINE(modernize-use-nullptr): taken for the 0 that the operator is compared with
    auto operator<=>(const TomlPlace&) const = default;
    /// "line:column".
    std::string text() const { return std::to_string(line) + ":" + std::to_string(column); }
};

struct TomlEntry;

/// A date with a time and, if the file has one, its offset from universal time.
struct TomlDateTime {
    int year = 0, month = 1, day = 1; ///< of the Gregorian calendar
    double hours = 0;                 ///< after midnight
    std::optional<double> offset{};   ///< hours, positive in the east
};

/// A value of a file. monostate: a kind that no format of Keiko uses (dates or times alone).
struct TomlValue {
    /// Value itself. An array holds values in the order of the file, a table entries by rising key.
    std::variant<std::monostate, double, std::int64_t, std::string, std::vector<TomlValue>,
                 std::vector<TomlEntry>, bool, TomlDateTime>
        content;
    TomlPlace place; ///< at which the value begins

    /// "number", "text", "array", "table", "flag", "date and time" or "other".
    std::string_view kind() const {
        static constexpr std::string_view kinds[] = {"other", "number", "number", "text",
                                                     "array", "table",  "flag",   "date and time"};
        return kinds[content.index()];
    }
};

/// A key of a table with its value.
struct TomlEntry {
    std::string key; ///< a single word, without those of the tables around it
    TomlPlace place; ///< of the key
    TomlValue value; ///< that the key holds
};

/// A file: what it is called, and its root table.
struct TomlDocument {
    std::filesystem::path source; ///< path for messages, as given
    TomlValue root;               ///< always a table
    bool may_name_files = true;   ///< false: of a text from elsewhere, whose names are not followed
};

/// Document of a text; `source` is the path for messages. Throws Error for a text that is no TOML,
/// with the line and mostly the column.
TomlDocument parse_toml(std::string_view text, const std::string& source);

/// A TOML file and every file that it names, sorted, each once. A text names a file if it is the
/// path of a regular file relative to the folder of the TOML file. TOML files named so are followed
/// too. The list is a superset of what reading the file takes, whatever its format. Throws Error
/// for a file that cannot be parsed.
std::vector<std::filesystem::path> files_named_by(const std::filesystem::path& toml_file);

} // namespace keiko
