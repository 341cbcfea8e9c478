// The getters of TomlTable: values of one type each, checked.
#include "keiko/base/text.h"
#include "keiko/files/toml/toml_document.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// A file system takes it for the end of a path: another file would be read than the text names.
void refuse_nul(const TomlTable& table, std::string_view key, const std::string& text) {
    if (text.find('\0') != std::string::npos)
        throw table.error(key, in_quotes(text) + " has a NUL character, written \\u0000");
}

} // namespace

double TomlTable::checked(std::string_view key, const TomlValue& value, const TomlLimits& limits,
                          const std::string& which) const {
    const auto* whole = std::get_if<std::int64_t>(&value.content);
    const auto* real = std::get_if<double>(&value.content);
    if (!whole && !real) throw error(key, "must be a number" + which);
    const double number = whole ? static_cast<double>(*whole) : *real;
    if (!std::isfinite(number)) throw error(key, "must be a finite number" + which);
    const bool high_enough = limits.above_low ? number > limits.low : number >= limits.low;
    if (high_enough && number <= limits.high) return number;
    std::string range;
    if (std::isfinite(limits.low))
        range = (limits.above_low ? "above " : "at least ") + toml_number(limits.low);
    if (std::isfinite(limits.high))
        range += (range.empty() ? "" : " and ") + ("at most " + toml_number(limits.high));
    throw error(key, "must be " + range + ", is " + toml_number(number) + which);
}

std::optional<double> TomlTable::number(std::string_view key, const TomlLimits& limits) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    return checked(key, entry->value, limits);
}

std::optional<int> TomlTable::integer(std::string_view key, int low, int high) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    if (entry->value.kind() != "number") throw mismatch(key, "a whole number");
    const double number = checked(
        key, entry->value, {.low = static_cast<double>(low), .high = static_cast<double>(high)});
    if (number != std::floor(number)) throw mismatch(key, "a whole number");
    return static_cast<int>(number);
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    const auto* content = std::get_if<std::string>(&entry->value.content);
    if (!content) throw mismatch(key, "a text in quotes");
    refuse_nul(*this, key, *content);
    return *content;
}

std::optional<std::size_t> TomlTable::choice(
    std::string_view key, std::initializer_list<std::string_view> choices) const {
    const std::optional<std::string> typed = text(key);
    if (!typed) return {};
    const auto found = std::find(choices.begin(), choices.end(), *typed);
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    const std::vector<std::string> words(choices.begin(), choices.end());
    throw error(key, "'" + shortened(*typed) + "' is none of " + comma_list(words) +
                         did_you_mean(*typed, words));
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key, std::size_t count,
                                                      const TomlLimits& limits) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    const auto* array = std::get_if<std::vector<TomlValue>>(&entry->value.content);
    if (!array || array->size() != count)
        throw mismatch(key, "an array of " + std::to_string(count) + " numbers");
    std::vector<double> result;
    for (const TomlValue& value : *array) result.push_back(checked(key, value, limits));
    return result;
}

std::vector<double> TomlTable::checked_list(std::string_view key, const TomlValue& value,
                                            const TomlLimits& limits, const std::string& of) const {
    const auto* array = std::get_if<std::vector<TomlValue>>(&value.content);
    if (!array || array->empty()) throw mismatch(key, "an array of numbers");
    std::vector<double> result;
    for (const TomlValue& element : *array) {
        const std::string which = " (number " + std::to_string(result.size() + 1) + of + ')';
        result.push_back(checked(key, element, limits, of.empty() ? of : which));
    }
    return result;
}

std::optional<std::vector<double>> TomlTable::list(std::string_view key,
                                                   const TomlLimits& limits) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    return checked_list(key, entry->value, limits);
}

std::optional<std::vector<std::vector<double>>> TomlTable::lists(std::string_view key,
                                                                 const TomlLimits& limits) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    const auto* array = std::get_if<std::vector<TomlValue>>(&entry->value.content);
    if (!array || array->empty()) throw mismatch(key, "an array of arrays of numbers");
    std::vector<std::vector<double>> result;
    for (const TomlValue& value : *array)
        result.push_back(
            checked_list(key, value, limits, " of array " + std::to_string(result.size() + 1)));
    return result;
}

std::optional<std::vector<std::pair<double, std::vector<double>>>> TomlTable::keyed_lists(
    std::string_view key, const TomlLimits& limits) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    const std::string wanted = "an array of arrays [number, number or numbers]";
    const auto* array = std::get_if<std::vector<TomlValue>>(&entry->value.content);
    if (!array || array->empty()) throw mismatch(key, wanted);
    std::vector<std::pair<double, std::vector<double>>> result;
    for (const TomlValue& value : *array) {
        const auto* pair = std::get_if<std::vector<TomlValue>>(&value.content);
        if (!pair || pair->size() != 2) throw mismatch(key, wanted);
        const TomlValue& second = (*pair)[1];
        result.emplace_back(checked(key, (*pair)[0], {}),
                            second.kind() == "array"
                                ? checked_list(key, second, limits)
                                : std::vector<double>{checked(key, second, limits)});
    }
    return result;
}

std::optional<bool> TomlTable::flag(std::string_view key) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    const auto* content = std::get_if<bool>(&entry->value.content);
    if (!content) throw mismatch(key, "true or false");
    return *content;
}

std::optional<TomlDateTime> TomlTable::date_time(std::string_view key) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    const auto* content = std::get_if<TomlDateTime>(&entry->value.content);
    if (!content || !content->offset)
        throw mismatch(
            key, "a date and a time with an offset, without quotes, as 2026-06-21T14:30:00+02:00");
    return *content;
}

std::optional<std::vector<std::string>> TomlTable::texts(std::string_view key) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    const auto* array = std::get_if<std::vector<TomlValue>>(&entry->value.content);
    if (!array) throw mismatch(key, "an array of texts");
    std::vector<std::string> result;
    for (const TomlValue& value : *array) {
        const auto* text = std::get_if<std::string>(&value.content);
        if (!text) throw mismatch(key, "an array of texts");
        refuse_nul(*this, key, *text);
        result.push_back(*text);
    }
    return result;
}

std::optional<Vec3> TomlTable::vector(std::string_view key) const {
    const auto values = numbers(key, 3, TomlLimits::place());
    if (!values) return {};
    return Vec3((*values)[0], (*values)[1], (*values)[2]);
}

std::optional<Rgb> TomlTable::rgb(std::string_view key, const TomlLimits& limits) const {
    const std::string_view given = kind(key);
    if (given.empty()) return {};
    if (given == "number") return Rgb(*number(key, limits));
    if (given != "array") throw mismatch(key, "a number or an array of 3 numbers");
    const auto values = numbers(key, 3, limits);
    return Rgb((*values)[0], (*values)[1], (*values)[2]);
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    if (entry->value.kind() != "table") throw mismatch(key, "a table");
    return TomlTable(document_, entry->value, path_of(key));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
    const TomlEntry* entry = find(key);
    if (!entry) return {};
    const auto* array = std::get_if<std::vector<TomlValue>>(&entry->value.content);
    if (!array) throw mismatch(key, "an array of tables, [[" + path_of(key) + "]]");
    std::vector<TomlTable> result;
    for (const TomlValue& value : *array) {
        if (value.kind() != "table") throw mismatch(key, "an array of tables");
        result.push_back(
            TomlTable(document_, value, path_of(key) + "[" + std::to_string(result.size()) + "]"));
    }
    return result;
}

} // namespace keiko
