#include "keiko/io/toml_reader.h"

#include "keiko/base/error_text.h"
#include "keiko/base/input_file.h"
#include "keiko/io/toml_guard.h"
#include "keiko/spec/suggestion.h"

#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <variant>

namespace keiko {

struct TomlTable::Value {
    /// monostate: a kind that no format of Keiko uses (dates).
    std::variant<std::monostate, double, std::int64_t, std::string, std::vector<Value>,
                 std::vector<Entry>, bool>
        content;
    std::uint32_t line = 0, column = 0;

    Value(const toml::node& node);
    std::string_view kind() const {
        static constexpr std::string_view kinds[] = {"other", "number", "number", "text",
                                                     "array", "table",  "flag"};
        return kinds[content.index()];
    }
};

struct TomlTable::Entry {
    std::string key;
    std::uint32_t line = 0, column = 0; ///< of the key
    Value value;
};

struct TomlTable::Document {
    std::filesystem::path source;
    Value root;
};

namespace {

std::string place(std::uint32_t line, std::uint32_t column) {
    return std::to_string(line) + ":" + std::to_string(column);
}

} // namespace

TomlTable::Value::Value(const toml::node& node)
    : line(node.source().begin.line), column(node.source().begin.column) {
    if (const auto* real = node.as_floating_point()) content = real->get();
    if (const auto* whole = node.as_integer()) content = whole->get();
    if (const auto* text = node.as_string()) content = text->get();
    if (const auto* flag = node.as_boolean()) content = flag->get();
    if (const auto* array = node.as_array()) {
        std::vector<Value> values;
        for (const toml::node& element : *array) values.emplace_back(element);
        content = std::move(values);
    }
    if (const auto* table = node.as_table()) {
        std::vector<Entry> entries;
        for (const auto& [key, element] : *table)
            entries.push_back({std::string(key.str()), key.source().begin.line,
                               key.source().begin.column, Value(element)});
        content = std::move(entries);
    }
}

TomlTable::TomlTable(std::shared_ptr<const Document> document, const Value& value, std::string name)
    : document_(std::move(document)), value_(&value), name_(std::move(name)) {}

TomlTable TomlTable::parse(std::string_view text, const std::string& source) {
    require_parsable_toml(text, source);
    try {
        const toml::table root = toml::parse(text, source);
        const auto document = std::make_shared<const Document>(Document{source, Value(root)});
        return {document, document->root, ""};
    } catch (const toml::parse_error& error) {
        const toml::source_position at = error.source().begin;
        throw Error(source, place(at.line, at.column), shortened(error.description()));
    }
}

TomlTable TomlTable::read(const std::filesystem::path& path) {
    return parse(read_file(path), path.string());
}

const TomlTable::Entry* TomlTable::find(std::string_view key) const {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
    for (const Entry& entry : std::get<std::vector<Entry>>(value_->content))
        if (entry.key == key) return &entry;
    return nullptr;
}

bool TomlTable::has(std::string_view key) const {
    return find(key) != nullptr;
}

std::string_view TomlTable::kind(std::string_view key) const {
    const Entry* entry = find(key);
    return entry ? entry->value.kind() : "";
}

double TomlTable::checked(std::string_view key, const Value& value,
                          const TomlLimits& limits) const {
    const auto* whole = std::get_if<std::int64_t>(&value.content);
    const auto* real = std::get_if<double>(&value.content);
    if (!whole && !real) throw mismatch(key, "a number");
    const double number = whole ? static_cast<double>(*whole) : *real;
    if (!std::isfinite(number)) throw error(key, "must be a finite number");
    const bool high_enough = limits.above_low ? number > limits.low : number >= limits.low;
    if (high_enough && number <= limits.high) return number;
    std::string range;
    if (std::isfinite(limits.low))
        range = (limits.above_low ? "above " : "at least ") + toml_number(limits.low);
    if (std::isfinite(limits.high))
        range += (range.empty() ? "" : " and ") + ("at most " + toml_number(limits.high));
    throw error(key, "must be " + range + ", is " + toml_number(number));
}

std::optional<double> TomlTable::number(std::string_view key, const TomlLimits& limits) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    return checked(key, entry->value, limits);
}

std::optional<int> TomlTable::integer(std::string_view key, int low, int high) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    if (!std::holds_alternative<std::int64_t>(entry->value.content))
        throw mismatch(key, "a whole number");
    return static_cast<int>(checked(
        key, entry->value, {.low = static_cast<double>(low), .high = static_cast<double>(high)}));
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    const auto* content = std::get_if<std::string>(&entry->value.content);
    if (!content) throw mismatch(key, "a text in quotes");
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
    const Entry* entry = find(key);
    if (!entry) return {};
    const auto* array = std::get_if<std::vector<Value>>(&entry->value.content);
    if (!array || array->size() != count)
        throw mismatch(key, "an array of " + std::to_string(count) + " numbers");
    std::vector<double> result;
    for (const Value& value : *array) result.push_back(checked(key, value, limits));
    return result;
}

std::vector<double> TomlTable::checked_list(std::string_view key, const Value& value,
                                            const TomlLimits& limits) const {
    const auto* array = std::get_if<std::vector<Value>>(&value.content);
    if (!array || array->empty()) throw mismatch(key, "an array of numbers");
    std::vector<double> result;
    for (const Value& element : *array) result.push_back(checked(key, element, limits));
    return result;
}

std::optional<std::vector<double>> TomlTable::list(std::string_view key,
                                                   const TomlLimits& limits) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    return checked_list(key, entry->value, limits);
}

std::optional<std::vector<std::vector<double>>> TomlTable::lists(std::string_view key,
                                                                 const TomlLimits& limits) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    const auto* array = std::get_if<std::vector<Value>>(&entry->value.content);
    if (!array || array->empty()) throw mismatch(key, "an array of arrays of numbers");
    std::vector<std::vector<double>> result;
    for (const Value& value : *array) result.push_back(checked_list(key, value, limits));
    return result;
}

std::optional<std::vector<std::pair<double, std::vector<double>>>> TomlTable::keyed_lists(
    std::string_view key) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    const std::string wanted = "an array of arrays [number, number or numbers]";
    const auto* array = std::get_if<std::vector<Value>>(&entry->value.content);
    if (!array || array->empty()) throw mismatch(key, wanted);
    std::vector<std::pair<double, std::vector<double>>> result;
    for (const Value& value : *array) {
        const auto* pair = std::get_if<std::vector<Value>>(&value.content);
        if (!pair || pair->size() != 2) throw mismatch(key, wanted);
        const Value& second = (*pair)[1];
        result.emplace_back(checked(key, (*pair)[0], {}),
                            second.kind() == "array"
                                ? checked_list(key, second, {})
                                : std::vector<double>{checked(key, second, {})});
    }
    return result;
}

std::optional<bool> TomlTable::flag(std::string_view key) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    const auto* content = std::get_if<bool>(&entry->value.content);
    if (!content) throw mismatch(key, "true or false");
    return *content;
}

std::optional<std::vector<std::string>> TomlTable::texts(std::string_view key) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    const auto* array = std::get_if<std::vector<Value>>(&entry->value.content);
    if (!array) throw mismatch(key, "an array of texts");
    std::vector<std::string> result;
    for (const Value& value : *array) {
        const auto* text = std::get_if<std::string>(&value.content);
        if (!text) throw mismatch(key, "an array of texts");
        result.push_back(*text);
    }
    return result;
}

std::optional<Vec3> TomlTable::vector(std::string_view key) const {
    const auto values = numbers(key, 3);
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
    const Entry* entry = find(key);
    if (!entry) return {};
    if (entry->value.kind() != "table") throw mismatch(key, "a table");
    return TomlTable(document_, entry->value, path_of(key));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
    const Entry* entry = find(key);
    if (!entry) return {};
    const auto* array = std::get_if<std::vector<Value>>(&entry->value.content);
    if (!array) throw mismatch(key, "an array of tables, [[" + path_of(key) + "]]");
    std::vector<TomlTable> result;
    for (const Value& value : *array) {
        if (value.kind() != "table") throw mismatch(key, "an array of tables");
        result.push_back(
            TomlTable(document_, value, path_of(key) + "[" + std::to_string(result.size()) + "]"));
    }
    return result;
}

void TomlTable::require_format(std::string_view expected) const {
    const std::string wanted = "format = \"" + std::string(expected) + "\"";
    const std::optional<std::string> given = text("format");
    if (!given) throw error("", "the file must begin with " + wanted);
    if (*given != expected)
        throw error("format", "is '" + shortened(*given) + "'; expected " + wanted);
}

void TomlTable::not_yet(std::initializer_list<std::string_view> keys) const {
    for (const std::string_view key : keys)
        if (has(key)) throw error(key, "is not supported yet");
}

void TomlTable::finish() const {
    const Entry* first = nullptr;
    for (const Entry& entry : std::get<std::vector<Entry>>(value_->content)) {
        if (std::find(asked_.begin(), asked_.end(), entry.key) != asked_.end()) continue;
        if (!first || std::pair(entry.line, entry.column) < std::pair(first->line, first->column))
            first = &entry;
    }
    if (!first) return;
    throw Error(
        document_->source.string(), place(first->line, first->column),
        "unknown key '" + shortened(path_of(first->key)) + "'" + did_you_mean(first->key, asked_));
}

Error TomlTable::error(std::string_view key, const std::string& reason) const {
    const Entry* entry = key.empty() ? nullptr : find(key);
    const Value& at = entry ? entry->value : *value_;
    const std::string subject = key.empty() ? name_ : path_of(key);
    return {document_->source.string(), place(at.line, at.column),
            subject.empty() ? reason : subject + ": " + reason};
}

std::string TomlTable::path_of(std::string_view key) const {
    return name_.empty() ? std::string(key) : name_ + "." + std::string(key);
}

Error TomlTable::missing(std::string_view key) const {
    return error("", "'" + std::string(key) + "' is missing");
}

Error TomlTable::mismatch(std::string_view key, const std::string& wanted) const {
    return error(key, "must be " + wanted);
}

std::uint32_t TomlTable::line() const {
    return value_->line;
}

const std::filesystem::path& TomlTable::source() const {
    return document_->source;
}

std::string toml_number(double value) {
    char buffer[32];
    const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value).ptr;
    std::string text(buffer, end);
    // Without a point TOML reads an integer, which has no -0 and ends at 2^63.
    const bool whole = text.find_first_of(".e") == std::string::npos;
    const bool no_integer = text == "-0" || std::abs(value) > 1e15;
    return whole && no_integer ? text + ".0" : text;
}

} // namespace keiko
