#pragma once

#include "keiko/base/error.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace keiko {

/// Words on what a file of this format of Keiko's own ("keiko-rig/1") is and what takes it: "a rig:
/// inspect, render and lines take it as their rig". Empty for any other text.
std::string use_of_format(std::string_view format);

struct TomlDateTime;
struct TomlDocument;
struct TomlEntry;
struct TomlValue;

/// Range of a number of a file.
struct TomlLimits {
    double low = -std::numeric_limits<double>::infinity(); ///< least value
    double high = std::numeric_limits<double>::infinity(); ///< largest value, allowed itself
    bool above_low = false;                                ///< low itself is not allowed

    /// Numbers above 0.
    static constexpr TomlLimits positive() { return {.low = 0, .above_low = true}; }
    /// Numbers from 0.
    static constexpr TomlLimits not_negative() { return {.low = 0}; }
    /// Numbers from 0 to 1.
    static constexpr TomlLimits share() { return {.low = 0, .high = 1}; }
    /// Coordinates in mm, and those of directions: up to a thousand kilometres.
    static constexpr TomlLimits place() { return {.low = -1e9, .high = 1e9}; }
    /// Sizes in mm.
    static constexpr TomlLimits length() { return {.low = 1e-6, .high = 1e9}; }
    /// Quantities of light, in any unit: products of a few stay finite.
    static constexpr TomlLimits light() { return {.low = 0, .high = 1e15}; }
};

/// A table of a TOML file, read key by key. Every getter returns nothing for a key that is absent.
/// It throws Error with file, line and column for a value of another type, not finite or out of
/// limits. finish() then rejects the keys that no getter requested.
class TomlTable {
public:
    /// The root table of a text; `source` is the file name for messages.
    static TomlTable parse(std::string_view text, const std::string& source);
    /// The root table of a text from elsewhere: keys that name files are errors in it.
    static TomlTable parse_alone(std::string_view text, const std::string& source);
    /// The root table of a file.
    static TomlTable read(const std::filesystem::path& path);

    /// True if the key is present; counts as a request of it.
    bool has(std::string_view key) const;
    /// A number within limits, whole or not.
    std::optional<double> number(std::string_view key, const TomlLimits& limits = {}) const;
    /// A whole number from `low` to `high`, both included; 2.0 is one as well.
    std::optional<int> integer(std::string_view key, int low, int high) const;
    /// A text without a NUL character.
    std::optional<std::string> text(std::string_view key) const;
    /// Position of the text in `choices`; Error for any other text.
    std::optional<std::size_t> choice(std::string_view key,
                                      std::initializer_list<std::string_view> choices) const;
    /// An array of `count` numbers.
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count,
                                               const TomlLimits& limits = {}) const;
    /// An array of any number of numbers, but at least one.
    std::optional<std::vector<double>> list(std::string_view key,
                                            const TomlLimits& limits = {}) const;
    /// An array of such arrays.
    std::optional<std::vector<std::vector<double>>> lists(std::string_view key,
                                                          const TomlLimits& limits = {}) const;
    /// An array of arrays of a number and what goes with it: a number, or an array of them, within
    /// limits.
    std::optional<std::vector<std::pair<double, std::vector<double>>>> keyed_lists(
        std::string_view key, const TomlLimits& limits = {}) const;
    /// A place or a direction, within TomlLimits::place().
    std::optional<Vec3> vector(std::string_view key) const;
    /// true or false.
    std::optional<bool> flag(std::string_view key) const;
    /// A date and a time with an offset, such as 2026-06-21T14:30:00+02:00.
    std::optional<TomlDateTime> date_time(std::string_view key) const;
    /// An array of texts.
    std::optional<std::vector<std::string>> texts(std::string_view key) const;
    /// One number, for grey, or three.
    std::optional<Rgb> rgb(std::string_view key, const TomlLimits& limits) const;
    /// A table within this one, which keeps the document alive.
    std::optional<TomlTable> table(std::string_view key) const;
    /// An array of tables; empty when absent.
    std::vector<TomlTable> tables(std::string_view key) const;
    /// Whether the key holds a text, a table, ... : "text", "table", "number", "array", "flag",
    /// "other", or "" when absent.
    std::string_view kind(std::string_view key) const;

    /// The value, or the Error of refuse_missing.
    template <class T>
    T required(std::string_view key, const std::optional<T>& value) const {
        if (!value) refuse_missing(key);
        return *value;
    }
    /// Throws Error at a key that no getter has requested and that resembles a requested key that
    /// is absent.
    void refuse_misspelt() const;
    /// Throws Error at a misspelt key, or else at this table saying that `key` is missing.
    [[noreturn]] void refuse_missing(std::string_view key) const;
    /// Throws Error unless `format = "expected"` stands in this table.
    void require_format(std::string_view expected) const;
    /// Throws Error 'not supported yet' where one of the keys is present.
    void not_yet(std::initializer_list<std::string_view> keys) const;
    /// Throws Error at the first key that no getter requested, suggesting one that was.
    void finish() const;

    /// An Error at the value of `key`, or at the table itself where the key is absent or "".
    Error error(std::string_view key, const std::string& reason) const;
    /// Line of the file at which this table begins; orders tables of different names.
    std::uint32_t line() const;
    /// The file this table was read from.
    const std::filesystem::path& source() const;
    /// True unless the text comes from elsewhere.
    bool may_name_files() const;

private:
    TomlTable(std::shared_ptr<const TomlDocument> document, const TomlValue& value,
              std::string name);

    const std::vector<TomlEntry>& entries() const;
    const TomlEntry* find(std::string_view key) const;
    bool asked_for(const TomlEntry& entry) const;
    std::string path_of(std::string_view key) const;
    Error unknown(const TomlEntry& entry, std::span<const std::string> known) const;
    Error mismatch(std::string_view key, const std::string& wanted) const;
    /// `which`: ends the message; `of`: names the array among several, as the message of a number
    /// in it does.
    double checked(std::string_view key, const TomlValue& value, const TomlLimits& limits,
                   const std::string& which = {}) const;
    std::vector<double> checked_list(std::string_view key, const TomlValue& value,
                                     const TomlLimits& limits, const std::string& of = {}) const;

    std::shared_ptr<const TomlDocument> document_; ///< keeps value_ alive
    const TomlValue* value_;
    std::string name_;                       ///< "c_plane[2]"; empty for the root
    mutable std::vector<std::string> asked_; ///< the keys this table may hold
};

/// The file that `key` names, relative to the file of `table`; nothing when the key is absent.
/// Throws Error with file, line and column where it cannot be read.
std::optional<std::filesystem::path> path_from(const TomlTable& table, std::string_view key);

/// The file of that name, which `key` gives, relative to the file of `table`. Throws as path_from.
std::filesystem::path readable_path(const TomlTable& table, std::string_view key,
                                    const std::string& name);

/// Colour that multiplies the light of a source, by its key `color`; white when absent.
Rgb color_of(const TomlTable& table);

/// Throws Error for `light`, which comes of the number at `key` and the colour, beyond what a
/// number of light may be: at the key if it is there, or else at the colour.
void require_light(const TomlTable& table, std::string_view key, const Rgb& light);

} // namespace keiko
