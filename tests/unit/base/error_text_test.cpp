#include "keiko/base/error.h"
#include "keiko/base/text.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(ErrorText, AnErrorIsOneLineWhateverTheFileHolds) {
    const Error error("a\nb.toml", "2:1", "unknown key 'x\r\x1b[31m\x7f'");
    EXPECT_STREQ(error.what(), "a?b.toml:2:1: unknown key 'x??[31m?'");
}

TEST(ErrorText, NothingControlsTheTerminal) {
    EXPECT_EQ(one_line("a\u009b31mb\u202ec\u2028d\u2066e"), "a?31mb?c?d?e");
    EXPECT_EQ(one_line("a\x9b"
                       "b\xff\xc3"),
              "a?b??")
        << "bytes that are no UTF-8";
    EXPECT_EQ(one_line("Kotfl\u00fcgel \u2013 \u5de6"), "Kotfl\u00fcgel \u2013 \u5de6");
}

TEST(TextLines, ANameStaysOnItsLine) {
    TextLines lines;
    lines.line("file") << "a\nb\x1b[2J.step";
    lines.line() << 3 << " faces";
    EXPECT_EQ(lines.text(), "file        a?b?[2J.step\n3 faces\n");
    EXPECT_EQ(TextLines().text(), "");
    EXPECT_EQ(terminal_text("one\n\x1btwo\r\n\n"), "one\n?two?\n\n");
    EXPECT_EQ(terminal_text("no end"), "no end");
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
