// TOML that is refused before its keys are read, and what looks like it.
#include "keiko/files/scene/rig_file.h"

#include "tests/support/rig_text.h"
#include <gtest/gtest.h>

#include <string>

namespace keiko {
namespace {

using test::rig_error;

const std::string head = "format = \"keiko-rig/1\"\n";
const std::string plane =
    "[[c_plane]]\norigin = [0, 0, 2000]\nu = [1000, 0, 0]\nv = [0, 1200, 0]\n";

TEST(RigSyntax, KeysOfVeryManyPartsAreRefusedBeforeTheyOverflowTheStack) {
    const auto parts = [](int count) {
        std::string key = "a";
        for (int i = 1; i < count; ++i) key += ".a";
        return key;
    };
    const std::string expected = "a key of more than 100 parts";
    EXPECT_EQ(rig_error(head + parts(200000) + " = 1\n"), "bad.toml:2: " + expected);
    EXPECT_EQ(rig_error(head + "[" + parts(200000) + "]\n"), "bad.toml:2: " + expected);
    EXPECT_EQ(rig_error(head + "x = [{" + parts(200000) + " = 1}]\n"), "bad.toml:2: " + expected);
    EXPECT_EQ(rig_error(head + parts(100) + " = 1\n"), "bad.toml:2:1: unknown key 'a'");
}

TEST(RigSyntax, CharactersBeyondAsciiStandInQuotesAndCommentsAlone) {
    const std::string bare = "a character beyond ASCII that is not in quotes";
    EXPECT_EQ(rig_error(head + "u = [7000, 0, \xcd\xa2"), "bad.toml:2: " + bare);
    EXPECT_EQ(rig_error(head + "\u00fc = 1\n"), "bad.toml:2: " + bare);
    EXPECT_EQ(rig_error(head + "# \u00fc\nname = \"\u00fc\"\nx = '\u00fc'\n"),
              "bad.toml:4:1: unknown key 'x'");
    EXPECT_EQ(rig_error("\xef\xbb\xbf" + head + "x = 1\n"), "bad.toml:2:1: unknown key 'x'");
}

TEST(RigSyntax, ABackslashIsFollowedByAscii) {
    const std::string joined = "a character beyond ASCII follows a backslash";
    EXPECT_EQ(rig_error(head + "name = \"\"\"a\\\n \u00a7\"\"\"\n"), "bad.toml:2: " + joined);
    EXPECT_EQ(rig_error(head + "name = \"\"\"a\\\u00a7\"\"\"\n"), "bad.toml:2: " + joined);
    EXPECT_EQ(rig_error(head + "name = \"\\\u00a7\"\n"), "bad.toml:2: " + joined);
    EXPECT_EQ(rig_error(head + "name = \"\"\"\u00a7\\\n a\u00a7\"\"\"\nx = 1\n"),
              "bad.toml:4:1: unknown key 'x'");
}

TEST(RigSyntax, QuotesBeginStringsWhereKeysAndValuesBegin) {
    const std::string stray = "a quotation mark where no string can begin";
    for (const std::string text : {"x = 0x:\"\u01b6\"\n", "x = 1.\"a\"\n", "x = [1.'a']\n",
                                   "x = [[1], 2.'a']\n", "x = \"a\"'b'\n", "x = it's\n"})
        EXPECT_EQ(rig_error(head + text), "bad.toml:2: " + stray) << text;
    for (const std::string text : {"x = 0x=\"\u01b6\"\n", "x = 1 = 2\n", "[x] = 1\n"})
        EXPECT_EQ(rig_error(head + text), "bad.toml:2: '=' where nothing can begin") << text;
    EXPECT_EQ(rig_error(head + "x = 1[\"\u01b6\"]\n"), "bad.toml:2: '[' where nothing can begin");
    EXPECT_EQ(rig_error(head + "x = 1{\"\u01b6\" = 1}\n"),
              "bad.toml:2: '{' where nothing can begin");
    for (const std::string text :
         {"x.\"\u00fc\".1.'b' = [\"\u00fc\",\n'\u00fc', # \"\n\"\u00fc\"]\n",
          "x = [{a.\"\u00fc\" = '\u00fc', \"b\" = 1}, [\"\u00fc\"]]\n",
          "[x.\"\u00fc\"]\n\"a\" = 1\n", "[[x]]\n\"a\" = '''\u00fc''''' # '\u00fc\n"})
        EXPECT_EQ(rig_error(head + text).find("quot"), std::string::npos) << text;
}

TEST(RigSyntax, ErrorsStayShortHoweverLongAKeyIs) {
    EXPECT_EQ(rig_error(head + std::string(5000, 'x') + " = 1\n"),
              "bad.toml:2:1: unknown key '" + std::string(300, 'x') + "...'");
}

TEST(RigSyntax, DotsInTextAndCommentsAreNoKeyParts) {
    const std::string dots(300, '.');
    for (const std::string& name :
         {"\"\\\"" + dots + "\"", "'" + dots + "\\'", "\"\"\"\n\"" + dots + "\n\"\"\"",
          "'''\n'" + dots + "'''", "\"\" # it's " + dots})
        EXPECT_NO_THROW(parse_rig(head + "name = " + name + "\n" + plane, "dots.toml")) << name;
}

} // namespace
} // namespace keiko
