#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// A whole HTML page in the report's style. `title` and `more_style` are inserted unchanged, `body`
/// is the content of its main part, and `script` follows it, if any.
std::string html_page(std::string_view title, std::string_view more_style, std::string_view body,
                      std::string_view script = {});

/// Sorts a table by the column whose heading was pressed, by the cells' data-v; pressing again
/// reverses the order. A row that has a close-up shows it when it is pressed, and so does the
/// close-up itself.
extern const std::string_view report_script;

/// Style of html_slider, for the page's style sheet.
extern const std::string_view slider_style;

/// Words of a slider for its pictures.
struct SliderWords {
    std::string before = "before"; ///< of the picture at the left
    std::string after = "after";   ///< of the picture at the right
    /// Words of the picture beside both.
    std::string difference =
        "difference, grey within, yellow to red beyond the tolerance, "
        "magenta where the outline or the face is another";
};

/// Pictures of a slider, each the bytes of a PNG file or empty for none.
struct SliderPictures {
    std::string_view before;     ///< the picture at the left of the slider
    std::string_view after;      ///< the picture at the right of the slider
    std::string_view difference; ///< the picture beside both
    int width = 0;               ///< pixels, of all three
    int height = 0;              ///< pixels, of all three
    SliderWords words{};         ///< for captions
};

/// Two pictures on top of each other with a slider that sets how much of the latter is visible, and
/// beside them their difference; a single picture if one is missing.
std::string html_slider(const SliderPictures& pictures, const std::string& title);

} // namespace keiko
