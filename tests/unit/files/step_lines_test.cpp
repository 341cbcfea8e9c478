#include "keiko/files/model/cad_text.h"

#include <gtest/gtest.h>

namespace keiko {

TEST(StepLines, AreThoseOnWhichEntitiesBegin) {
    const auto lines = step_entity_lines(
        "ISO-10303-21;\nDATA;\n#1 = POINT('',\n  (0.,1.));\n"
        "#20=FACE('a',#1); #3 =FACE('b',#20);\nENDSEC;\n");
    EXPECT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines.at(1), 3u);
    EXPECT_EQ(lines.at(20), 5u);
    EXPECT_EQ(lines.at(3), 5u);
}

TEST(StepLines, PassOverTextsAndComments) {
    const auto lines = step_entity_lines(
        "/* #9 = X;\n;*/ #1 = A('it''s;\n#7 = B', \"0;\" /*;*/);\n"
        "/* #8 */#2 /* = */ = C(#1);\n#4 = D();#4 = E();");
    EXPECT_EQ(lines.count(7) + lines.count(8) + lines.count(9), 0u);
    EXPECT_EQ(lines.at(1), 2u);
    EXPECT_EQ(lines.at(4), 5u);
}

TEST(StepLines, CountEveryKindOfLineEnd) {
    EXPECT_EQ(step_entity_lines("A;\r\nB;\r\n#1=C;").at(1), 3u);
    EXPECT_EQ(step_entity_lines("A;\rB;\r#1=C;").at(1), 3u);
}

TEST(StepLines, OfBrokenTextsAreThoseThatAreThere) {
    for (const char* text :
         {"", "#", "#12", "#=A;", "#99999999999999999999999=A;", "'", "/*", ";;"})
        EXPECT_TRUE(step_entity_lines(text).empty()) << text;
}

} // namespace keiko
