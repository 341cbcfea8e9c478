#pragma once

#include "keiko/drawing/sheet/sheet.h"
#include "keiko/math/bounds.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace keiko {

/// The part of a paper that is for views: within the frame, above the title block.
Box2 drawing_area(const Vec2& paper);

/// Adds the frame around the sheet.
void add_frame(Sheet& sheet);
/// Adds the title block at the lower right: the title and lines of notes, shortened to its width.
void add_title_block(Sheet& sheet, const std::string& title, std::span<const std::string> notes);
/// Adds lines of text left of the title block, as many as have room there.
void add_list(Sheet& sheet, std::span<const std::string> lines);
/// Adds a bar of a round length of the body at the lower left; `scale`: mm of paper a mm.
void add_scale_bar(Sheet& sheet, double scale);
/// Adds dimensions below and left of a view's box on the sheet; nullopt: none.
void add_dimensions(Sheet& sheet, const Box2& box, const std::optional<double>& width,
                    const std::optional<double>& height);
/// Adds a number in a circle; one at a hidden place is dashed.
void add_mark(Sheet& sheet, const Vec2& at, std::uint32_t number, bool visible);

} // namespace keiko
