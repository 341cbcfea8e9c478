#pragma once

#include "tests/support/paths.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

// Values that the JSON Schema of scenes refuses.

namespace keiko::test {

using nlohmann::json;

/// docs/schema/keiko.schema.json.
inline const json& schema() {
    static const json read = [] {
        std::ifstream file(test::repository("docs/schema/keiko.schema.json"));
        return json::parse(file);
    }();
    return read;
}

inline json resolved(const json& definition) {
    const auto ref = definition.find("$ref");
    if (ref == definition.end()) return definition;
    return resolved(schema().at(json::json_pointer(ref->get<std::string>().substr(1))));
}

/// A value that is wrong, as TOML, and the reason to be given.
struct WrongValue {
    std::string toml, reason;
    std::optional<std::array<double, 3>> range{}; ///< in the reason: limits and the number given
};

/// Numbers below and above the limits.
inline std::vector<WrongValue> beyond_limits(const json& number, const std::string& before = "",
                                             const std::string& after = "") {
    const double low = number["minimum"], high = number["maximum"];
    std::vector<WrongValue> wrong;
    for (const double value :
         {low - std::max(1.0, std::abs(low) / 10), high + std::max(1.0, std::abs(high) / 10)}) {
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), "%.15g", value);
        wrong.push_back(
            {before + digits.data() + after, "must be at least ", {{low, high, value}}});
    }
    return wrong;
}

inline void append(std::vector<WrongValue>& wrong, std::vector<WrongValue> more) {
    wrong.insert(wrong.end(), more.begin(), more.end());
}

/// The text "1, 1, " of `count` ones.
inline std::string ones(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += "1, ";
    return text;
}

inline std::vector<WrongValue> wrong_numbers(const json& number) {
    const bool whole = number["type"] == "integer";
    std::vector<WrongValue> wrong = beyond_limits(number);
    wrong.push_back({"\"x\"", whole ? "must be a whole number" : "must be a number"});
    wrong.push_back({"nan", "must be a finite number"});
    if (whole) wrong.push_back({number["minimum"].dump() + ".5", "must be a whole number"});
    return wrong;
}

inline std::vector<WrongValue> wrong_arrays(const json& array) {
    const std::size_t count = array["minItems"];
    const std::string all = "must be an array of " + std::to_string(count) + " numbers";
    const std::string most = "[" + ones(count - 1);
    std::vector<WrongValue> wrong{
        {most + "]", all}, {most + "1, 1]", all}, {most + "true]", "must be a number"}};
    append(wrong, beyond_limits(resolved(array["items"]), most, "]"));
    return wrong;
}

inline std::vector<WrongValue> wrong_corners(const json& array) {
    const json corner = resolved(array["items"]);
    const std::size_t count = corner["minItems"];
    const std::string right = "[" + ones(count) + "], ";
    std::string many;
    for (int i = 0; i <= 1000; ++i) many += right;
    std::vector<WrongValue> wrong{
        {"7", "must be an array of arrays of numbers"},
        {"[1, 2, 3]", "must be an array of numbers"},
        {"[" + right + right + "[1]]", "must be arrays of " + std::to_string(count) + " numbers"},
        {"[" + right + right + "]", "must be at least 3 corners"},
        {"[" + many + "]", "must be at most 1000 corners"}};
    append(wrong, beyond_limits(resolved(corner["items"]),
                                "[" + right + right + "[" + ones(count - 1), "]]"));
    return wrong;
}

/// One number or three.
inline std::vector<WrongValue> wrong_colors(const json& color) {
    std::vector<WrongValue> wrong = wrong_arrays(resolved(color["oneOf"][1]));
    append(wrong, beyond_limits(resolved(color["oneOf"][0])));
    wrong.push_back({"\"x\"", "must be a number or an array of 3 numbers"});
    return wrong;
}

/// All texts of these tables are names of files, or times.
inline std::vector<WrongValue> wrong_texts(const json& text) {
    if (!text.contains("format"))
        return {{"7", "must be a text in quotes"}, {"\"none.png\"", "none.png: no such file"}};
    std::vector<WrongValue> wrong;
    for (const char* value : {"7", "\"noon\"", "2026-06-21", "2026-06-21T14:30:00"})
        wrong.push_back({value, "must be a date and a time with an offset, without quotes"});
    return wrong;
}

inline std::vector<WrongValue> wrong_words(const json& word) {
    std::string choices;
    for (const std::string choice : word["enum"]) choices += (choices.empty() ? "" : ", ") + choice;
    return {{"7", "must be a text in quotes"},
            {"\"qqqqqqqq\"", "'qqqqqqqq' is none of " + choices}};
}

inline std::vector<WrongValue> wrong_lists(const json& array) {
    const json item = resolved(array["items"]);
    if (item["type"] == "array") return wrong_corners(array);
    if (item["type"] == "object")
        return {{"7", "must be an array of tables"}, {"[7]", "must be an array of tables"}};
    return wrong_arrays(array);
}

/// A word or a direction.
inline std::vector<WrongValue> wrong_directions(const json& direction) {
    std::vector<WrongValue> wrong = wrong_words(direction["oneOf"][0]);
    append(wrong, wrong_arrays(resolved(direction["oneOf"][1])));
    return wrong;
}

inline std::vector<WrongValue> wrong_values(const json& property) {
    const json definition = resolved(property);
    if (definition.contains("enum")) return wrong_words(definition);
    if (definition.contains("oneOf"))
        return definition["oneOf"][0].contains("enum") ? wrong_directions(definition)
                                                       : wrong_colors(definition);
    const std::string type = definition["type"];
    if (type == "array") return wrong_lists(definition);
    if (type == "string") return wrong_texts(definition);
    if (type == "boolean")
        return {{"7", "must be true or false"}, {"\"true\"", "must be true or false"}};
    if (type == "object") return {{"7", "must be a table"}};
    return wrong_numbers(definition);
}

} // namespace keiko::test
