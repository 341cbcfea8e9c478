#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A layer of a sheet: lines of one pen.
struct SheetLayer {
    std::string name;                       ///< "outlines", or "outlines hidden"
    double width = 0.25;                    ///< of the pen, mm
    bool dashed = false;                    ///< of 2 mm, 1 mm apart
    std::vector<std::vector<Vec2>> lines{}; ///< mm on the sheet, two points at least each
};

/// A line of text on a sheet.
struct SheetText {
    /// Place of the text relative to its point.
    enum class Anchor {
        start,  ///< it begins there
        middle, ///< its middle is there
        end     ///< it ends there
    };
    Vec2 at{0};                    ///< mm on the sheet, on the line that the letters stand on
    double height = 3;             ///< mm, of capital letters
    std::string text;              ///< UTF-8, one line
    Anchor anchor = Anchor::start; ///< where `at` is on it
    bool upright = true;           ///< false: turned left, to be read from the right
};

/// A sheet of paper with lines and text. Its origin is the lower left corner, y runs upwards.
struct Sheet {
    std::string title;              ///< of the file, UTF-8
    Vec2 size{420, 297};            ///< mm
    std::vector<SheetLayer> layers; ///< in the order of drawing
    std::vector<SheetText> texts{}; ///< above the lines
};

/// The layer of a name, added at the end with this pen if there is none yet.
SheetLayer& layer_of(Sheet& sheet, const std::string& name, double width, bool dashed = false);

} // namespace keiko
