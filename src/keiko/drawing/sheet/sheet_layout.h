#pragma once

#include "keiko/drawing/sheet/joined_strokes.h"
#include "keiko/drawing/sheet/sheet.h"
#include "keiko/math/bounds.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// A numbered mark on a view.
struct SheetMark {
    Vec2 at{0}; ///< in the image
    std::uint32_t number = 1;
    bool visible = true; ///< nothing lies before its place
};

/// A view of a sheet.
struct SheetView {
    std::string name;
    std::vector<Stroke> strokes;
    bool parallel = true;                    ///< its image is in mm and shown to scale
    std::optional<double> width{}, height{}; ///< mm, dimensions to be written; nullopt: none
    std::vector<SheetMark> marks{};
};

/// Box of the lines of a view in its image; empty without any.
Box2 image_box(const SheetView& view);

/// Options of laid_out.
struct SheetOptions {
    Vec2 paper{420, 297};     ///< mm, A3
    bool dash_hidden = false; ///< draw hidden lines dashed; otherwise they are left out
    /// Three views of one body in first-angle projection [ISO5456-2]: the first upper left, the
    /// second to its right and the third below it, all in one scale. Otherwise views fill a grid.
    bool three_views = false;
    std::vector<std::string>
        without{};                   ///< names of kinds that are not drawn; views keep their size
    std::string title;               ///< of the sheet
    std::vector<std::string> list{}; ///< lines of text beside the title block
};

/// Millimetres of paper for one of the body: the largest usual scale (1, 2 or 5 times a power of
/// ten, or one by that) that is not above `most`.
double usual_scale(double most);
/// "1:20", "2:1"
std::string scale_text(double scale);

/// The sheet of views: their lines in layers by kind, hidden ones apart, with frame, scale bar,
/// dimensions and title block. Parallel views share one usual scale; those in perspective fill
/// their cells. Throws Error for views without a line.
Sheet laid_out(std::span<const SheetView> views, const SheetOptions& options);

} // namespace keiko
