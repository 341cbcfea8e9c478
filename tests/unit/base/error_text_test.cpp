#include "keiko/base/error_text.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(ErrorText, AnErrorIsOneLineWhateverTheFileHolds) {
    const Error error("a\nb.toml", "2:1", "unknown key 'x\r\x1b[31m\x7f'");
    EXPECT_STREQ(error.what(), "a?b.toml:2:1: unknown key 'x??[31m?'");
}

TEST(ErrorText, LongTextEndsInDots) {
    EXPECT_EQ(shortened("short"), "short");
    EXPECT_EQ(shortened("abcdef", 6), "abcdef");
    EXPECT_EQ(shortened("abcdefg", 6), "abcdef...");
    EXPECT_EQ(shortened(std::string(1 << 20, 'x')).size(), 303u);
    EXPECT_EQ(in_quotes(std::string(50, '7')), '"' + std::string(40, '7') + "...\"");
}

TEST(ErrorText, LettersOfSeveralBytesAreNotCut) {
    EXPECT_EQ(shortened("abc\u00fcd", 4), "abc...");
    EXPECT_EQ(shortened("abc\u00fcd", 5), "abc\u00fc...");
    EXPECT_EQ(shortened("\x80\x80\x80", 2), "...");
}

} // namespace
} // namespace keiko
