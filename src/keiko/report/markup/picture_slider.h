#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// Style of html_slider, for the page's style sheet.
extern const std::string_view slider_style;

/// The bytes of PNG files; empty: none.
struct SliderPictures {
    std::string_view before, after, difference;
    int width = 0, height = 0;
};

/// Two pictures on top of each other with a slider that sets how much of the latter is visible, and
/// beside them their difference; a single picture if one is missing.
std::string html_slider(const SliderPictures& pictures, const std::string& title);

} // namespace keiko
