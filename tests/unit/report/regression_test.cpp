#include "keiko/report/content/regression.h"

#include "keiko/base/error.h"
#include "keiko/film/image_file.h"
#include "keiko/report/markup/junit_suites.h"
#include "keiko/report/record_files.h"

#include <gtest/gtest.h>

#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Film small_film() {
    Film film{Image(3, 2, 3, 1.5F), Image(3, 2, 1, 1), {}};
    film.aovs[Aov::depth] = Image(3, 2, 1, std::numeric_limits<float>::infinity());
    film.aovs[Aov::normal] = Image(3, 2, 3, 0.1F);
    return film;
}

KeptRecord small_record() {
    return {
        {{{"seams", "a | b: gap", Quantity::gap, 0.1},
          {"seams", "a | b: verdict", Quantity::verdict, std::string("fail")}},
         {{"front", small_film()}},
         {{{"auto", "front", {.eye = {0.1, -2e300, 3}, .width = 3, .height = 2}}}, "name = 1\n"}},
        "key",
        {{"2026-01-02T03:04:05Z", "me", "why", "keiko 1", {"one", "two"}}}};
}

TEST(RecordFiles, ReadBackAsTheyWere) {
    const FolderContent files = files_of(small_record());
    EXPECT_EQ(files.size(), 6u); // metrics, manifest, rig, color, depth, normal
    const KeptRecord read = record_of(files, "folder");
    EXPECT_EQ(read.record.metrics, small_record().record.metrics);
    EXPECT_EQ(read.record.setup, small_record().record.setup);
    EXPECT_EQ(read.key, "key");
    ASSERT_EQ(read.changes.size(), 1u);
    EXPECT_EQ(read.changes[0].changed, (std::vector<std::string>{"one", "two"}));
    ASSERT_EQ(read.record.pictures.size(), 1u);
    EXPECT_EQ(channels_of(read.record.pictures[0].film).image.values,
              channels_of(small_film()).image.values);
    EXPECT_EQ(files_of(read), files);
}

TEST(RecordFiles, AnyChangedMissingOrForeignFileIsToldByName) {
    const FolderContent files = files_of(small_record());
    for (const auto& [name, bytes] : files) {
        FolderContent changed = files;
        changed[name].back() = '?';
        EXPECT_THROW(record_of(changed, "folder"), Error) << name;
        changed.erase(name);
        EXPECT_THROW(record_of(changed, "folder"), Error) << name;
    }
    FolderContent more = files;
    more["front.uv.exr"] = files.at("front.depth.exr");
    EXPECT_THROW(record_of(more, "folder"), Error);
}

Regression small_regression() {
    Regression regression{.tool_version = "1", .suite = {"a", "b", "c"}, .shard = 2, .shards = 3};
    FixtureOutcome different{.name = "b", .state = FixtureState::different, .metrics_compared = 9};
    different.checks = {"shape", "seams", "lines"};
    different.metrics = {{"seams", "gap", Quantity::gap, 1.0, infinity, 0.5},
                         {"seams", "verdict", Quantity::verdict, std::string("<pass>"), {}, 0}};
    different.pictures = {{.view = "front",
                           .pixels = 6,
                           .layers = {{.layer = "color",
                                       .beyond = 2,
                                       .largest = infinity,
                                       .excess = infinity,
                                       .root_mean_square = 1,
                                       .within = false},
                                      {.layer = "depth"}}}};
    regression.fixtures = {different,
                           {.name = "c", .state = FixtureState::error, .error = "c.step: broken"}};
    return regression;
}

TEST(Regression, ItsJsonReadsBackAsItWas) {
    const std::string json = regression_json(small_regression());
    const Regression read = parse_regression(json, "file");
    EXPECT_EQ(regression_json(read), json);
    EXPECT_EQ(read.fixtures[0].metrics[0].after, (std::variant<double, std::string>(infinity)));
    EXPECT_EQ(read.state(), FixtureState::error);
    EXPECT_EQ(summary_of(read), "2 fixtures, 0 same, 1 different, 0 missing, 1 error");
}

TEST(Regression, JsonThatIsNoneIsRefusedWithTheFile) {
    for (const char* text : {"", "{", "{}", "[]", "{\"format\": \"keiko-report/1\"}"}) try {
            parse_regression(text, "out/regression.json");
            FAIL() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.file(), "out/regression.json");
        }
}

/// Text of a sound regression with `to` in place of `from`.
std::string changed_json(const std::string& from, const std::string& to) {
    std::string json = regression_json(small_regression());
    const std::size_t at = json.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return json.replace(at, from.size(), to);
}

void expect_refused(const std::string& json, const std::string& reason) {
    try {
        parse_regression(json, "r.json");
        FAIL() << reason;
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        EXPECT_LE(std::string(error.what()).size(), 1000u);
    }
}

TEST(Regression, CountsThatAreNoneAreRefused) {
    for (const char* count : {"1e300", "2.5", "-1", "3000000000", "\"1\"", "18446744073709551616"})
        expect_refused(changed_json("\"shards\": 3", std::string("\"shards\": ") + count),
                       "is no count");
    expect_refused(changed_json("\"shards\": 3", "\"shards\": 2.5"),
                   "r.json:shards: \"2.5\" is no count");
    expect_refused(changed_json("\"shards\": 3", "\"shards\": 1"), "is none of those there are");
}

TEST(Regression, WordsForNumbersAreThoseThatItWrites) {
    for (const char* word : {"\"infinity\"", "\"0x10\"", "\"\"", "\"1\""})
        expect_refused(changed_json("\"inf\"", word), "is no number");
}

TEST(Regression, NamesThatWouldLeaveTheFolderAreRefused) {
    for (const char* name : {"/tmp/x", "../x", "..", ".", ""}) {
        Regression regression = small_regression();
        regression.suite[1] = regression.fixtures[0].name = name;
        expect_refused(regression_json(regression), "is no name of a fixture");
    }
    expect_refused(changed_json("\"name\": \"b\"", "\"name\": \"other\""),
                   "is no fixture of the suite");
}

TEST(Regression, RefusalsAreShort) {
    const std::string far(5000, 'x');
    expect_refused("{\"format\": " + far, "cannot be read");
    expect_refused(changed_json("\"inf\"", '"' + far + '"'), "is no number");
}

TEST(Regression, JunitHasACaseForEachCheckViewAndLayer) {
    const std::string xml = regression_junit(small_regression());
    EXPECT_NE(xml.find("<testsuites name=\"keiko\" tests=\"7\" failures=\"2\" errors=\"1\">"),
              std::string::npos)
        << xml;
    EXPECT_NE(xml.find("name=\"front: color\">\n      <failure"), std::string::npos);
    EXPECT_NE(xml.find("name=\"front: depth\"/>"), std::string::npos);
    EXPECT_NE(xml.find("&lt;pass&gt; -&gt; none"), std::string::npos);
    EXPECT_NE(xml.find("<error message=\"c.step: broken\"/>"), std::string::npos);
}

TEST(Regression, ThePageShowsWhatIsNotTheSameAndNamesTheRest) {
    Regression regression = small_regression();
    regression.fixtures.push_back({.name = "fine"});
    const std::string html = regression_html(regression);
    EXPECT_NE(html.find("<section id=\"b\">"), std::string::npos);
    EXPECT_EQ(html.find("<section id=\"fine\">"), std::string::npos);
    EXPECT_NE(html.find("<h2>Same</h2><p>fine</p>"), std::string::npos);
}

} // namespace
} // namespace keiko
