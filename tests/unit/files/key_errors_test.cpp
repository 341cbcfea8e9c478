// Every key of the tables of lamps, daylight, surroundings, lobes and maps: missing, of a wrong
// type, out of its range, misspelt. Types and ranges are those of the JSON Schema, so that it and
// the program agree.
#include "keiko/base/error.h"
#include "keiko/files/scene/scene_file.h"

#include "tests/unit/files/key_tables.h"
#include "tests/unit/files/schema_faults.h"
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>

namespace keiko {
namespace {

using nlohmann::json;
using test::all_tables;
using test::Keys;
using test::schema;
using test::Table;
using test::WrongValue;

/// The message of the Error that a scene causes; "" when there is none.
std::string scene_error(const std::string& text) {
    try {
        parse_scene(text, "bad.toml");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string at(std::size_t line, std::size_t column) {
    return "bad.toml:" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

void expect_refused(const Table& table, const std::string& key, const WrongValue& wrong) {
    const std::string text = table.with(key, wrong.toml), message = scene_error(text);
    const std::string start =
        at(table.line(key), key.size() + 4) + table.path + "." + key + ": " + wrong.reason;
    EXPECT_TRUE(message.starts_with(start)) << message << "\nexpected " << start << "\n" << text;
    if (!wrong.range || message.size() <= start.size()) return;
    double low = 0, high = 0, given = 0;
    EXPECT_EQ(std::sscanf(message.c_str() + start.size(), "%lf and at most %lf, is %lf", &low,
                          &high, &given),
              3)
        << message;
    EXPECT_EQ((std::array{low, high, given}), *wrong.range) << message;
}

TEST(KeyErrors, TablesAreRightWithoutAChange) {
    for (const Table& table : all_tables())
        EXPECT_EQ(scene_error(table.text(table.keys)), "") << table.text(table.keys);
}

TEST(KeyErrors, WrongValuesAreNamedByPlaceKeyAndRange) {
    int refused = 0;
    for (const Table& table : all_tables()) {
        const json& properties = schema().at(json::json_pointer(table.definition))["properties"];
        for (const auto& [key, value] : table.keys)
            for (const WrongValue& wrong : test::wrong_values(properties.at(key))) {
                expect_refused(table, key, wrong);
                ++refused;
            }
    }
    EXPECT_GT(refused, 400);
}

TEST(KeyErrors, MissingKeysAreNamedAtTheTable) {
    for (const Table& table : all_tables()) {
        const json& definition = schema().at(json::json_pointer(table.definition));
        for (const std::string key : definition.value("required", json::array()))
            EXPECT_EQ(scene_error(table.without(key)),
                      at(table.line(), 1) + table.path + ": '" + key + "' is missing");
    }
}

TEST(KeyErrors, UnknownKeysAreNamedAndCorrected) {
    for (const Table& table : all_tables()) {
        Keys more = table.keys;
        more.emplace_back("no_such_key", "1");
        const std::size_t line = table.line(table.keys.back().first) + 1;
        EXPECT_EQ(scene_error(table.text(more)),
                  at(line, 1) + "unknown key '" + table.path + ".no_such_key'");
        const auto& [last, value] = table.keys.back();
        Keys misspelt = table.keys;
        misspelt.back().first = last + "x";
        const std::string message = scene_error(table.text(misspelt));
        EXPECT_EQ(message, at(line - 1, 1) + "unknown key '" + table.path + "." + last +
                               "x' (did you mean '" + last + "'?)");
    }
}

TEST(KeyErrors, NoKeyOfTheSchemaIsLeftOut) {
    std::map<std::string, std::set<std::string>> tried;
    for (const Table& table : all_tables())
        for (const auto& [key, value] : table.keys) tried[table.definition].insert(key);
    for (const auto& [definition, keys] : tried) {
        std::set<std::string> known;
        for (const auto& [key, property] :
             schema().at(json::json_pointer(definition))["properties"].items())
            known.insert(key);
        EXPECT_EQ(keys, known) << definition;
    }
}

} // namespace
} // namespace keiko
