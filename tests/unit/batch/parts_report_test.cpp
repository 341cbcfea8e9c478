#include "keiko/batch/parts_report.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

PartsRun three_parts() {
    return {.command = "check",
            .tool_version = "1.0",
            .key = "key",
            .shard = 2,
            .shards = 3,
            .all = {"a", "b", "c<d", "e"},
            .parts = {{"a", "in/a.step", PartState::pass, "fine", "inspection.json"},
                      {"b", "in/b.step", PartState::error, "in/b.step: no such file", ""},
                      {"c<d", "in/c.step", PartState::fail, "1 & 2", "inspection.json"}}};
}

std::string reason_against(std::string json, const std::string& from, const std::string& to) {
    json.replace(json.find(from), from.size(), to);
    try {
        parse_parts(json, "parts.json");
        return "none";
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), "parts.json");
        return error.what();
    }
}

TEST(PartsRun, IsReadAsItWasWritten) {
    const std::string json = parts_json(three_parts());
    EXPECT_EQ(parts_json(parse_parts(json, "parts.json")), json);
}

TEST(PartsRun, HasTheWorstStateOfItsParts) {
    EXPECT_EQ(three_parts().state(), PartState::error);
    EXPECT_EQ(PartsRun().state(), PartState::pass);
    EXPECT_EQ(summary_of(three_parts()), "3 parts, 1 pass, 0 undecided, 1 fail, 1 error");
}

TEST(PartsRun, OfUnsoundValuesIsRefused) {
    const std::string json = parts_json(three_parts());
    EXPECT_EQ(reason_against(json, "keiko-parts/1", "keiko-parts/1"), "none");
    EXPECT_NE(reason_against(json, "keiko-parts/1", "keiko-parts/2"), "none");
    EXPECT_NE(reason_against(json, "\"shard\": 2", "\"shard\": 4"), "none");
    EXPECT_NE(reason_against(json, "\"shard\": 2", "\"shard\": -1"), "none");
    EXPECT_NE(reason_against(json, "\"e\"", "\"../e\""), "none");
    EXPECT_NE(reason_against(json, "\"name\": \"a\"", "\"name\": \"z\""), "none");
    EXPECT_NE(reason_against(json, "\"fail\"", "\"failed\""), "none");
    EXPECT_NE(reason_against(json, "{", ""), "none");
}

TEST(PartOutcome, IsThatOfItsKeyAlone) {
    const PartOutcome part = three_parts().parts.front();
    const std::string json = part_json(part, "key");
    EXPECT_EQ(parse_part(json, "key", "part.json").summary, "fine");
    EXPECT_TRUE(parse_part(json, "other", "part.json").name.empty());
    EXPECT_THROW(parse_part("{", "key", "part.json"), Error);
}

TEST(PartsPage, LeadsToThePagesOfParts) {
    const std::string page = parts_html(three_parts());
    EXPECT_NE(page.find("<a href=\"parts/a/results/inspection.json\">a</a>"), std::string::npos);
    EXPECT_NE(page.find("parts/c&lt;d/results"), std::string::npos);
    EXPECT_EQ(page.find("parts/b/results"), std::string::npos);
    EXPECT_EQ(page.find("c<d"), std::string::npos);
}

TEST(PartsJunit, HasACaseAPart) {
    const std::string xml = parts_junit(three_parts());
    EXPECT_NE(xml.find("tests=\"3\""), std::string::npos) << xml;
    EXPECT_NE(xml.find("failures=\"1\""), std::string::npos);
    EXPECT_NE(xml.find("errors=\"1\""), std::string::npos);
    EXPECT_NE(xml.find("1 &amp; 2"), std::string::npos);
}

} // namespace
} // namespace keiko
