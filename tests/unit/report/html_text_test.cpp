#include "keiko/report/markup/html_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace keiko {
namespace {

TEST(Base64, HoldsTheVectorsOfRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(HtmlEscaped, DisarmsMarkup) {
    EXPECT_EQ(html_escaped("<script>alert('a' && \"b\")</script>"),
              "&lt;script&gt;alert(&#39;a&#39; &amp;&amp; &quot;b&quot;)&lt;/script&gt;");
}

TEST(HtmlEscaped, KeepsUtf8AndReplacesOtherBytes) {
    EXPECT_EQ(html_escaped("Kotflügel 螢光"), "Kotflügel 螢光");
    EXPECT_EQ(html_escaped("K\xfcgel"), "K\xef\xbf\xbdgel"); // Latin-1
    EXPECT_EQ(html_escaped("cut \xe8\x9e"), "cut \xef\xbf\xbd\xef\xbf\xbd");
    EXPECT_EQ(html_escaped(std::string("a\0b", 3)), "a b");
}

TEST(FixedNumber, TellsASmallValueFromNone) {
    EXPECT_EQ(fixed_number(0.01254, 3), "0.013");
    EXPECT_EQ(fixed_number(0, 3), "0.000");
    EXPECT_EQ(fixed_number(1e-9, 3), "< 0.001");
    EXPECT_EQ(fixed_number(std::numeric_limits<double>::quiet_NaN(), 3), "–");
}

TEST(HtmlBar, IsAlwaysAWidthThatBrowsersKnow) {
    const auto bar = [](const std::string& width) {
        return "<div class=\"bar\"><i style=\"width:" + width + "%\"></i></div>";
    };
    EXPECT_EQ(html_bar(0.25), bar("25.00"));
    EXPECT_EQ(html_bar(1e-9), bar("0.00"));
    EXPECT_EQ(html_bar(7), bar("100.00"));
    EXPECT_EQ(html_bar(std::numeric_limits<double>::quiet_NaN()), bar("0.00"));
}

TEST(PlaceText, HasNoNegativeZero) {
    EXPECT_EQ(place_text({-0.01, 12.345, -7}), "0.0, 12.3, -7.0");
}

} // namespace
} // namespace keiko
