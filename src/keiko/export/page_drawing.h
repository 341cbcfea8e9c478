#pragma once

#include "keiko/drawing/sheet/sheet_layout.h"

#include <span>
#include <string>
#include <vector>

namespace keiko {

/// A finding as pages mark it: its class of colour, "fail" or "undecided".
using FindingTones = std::span<const std::string>;

/// Views of one body as SVG for a page, whose style sheet gives the colours. They are three in
/// first-angle projection [ISO5456-2], as in SheetOptions::three_views, or one. Kinds of lines are
/// classes by name_of(), with "hidden"; hidden seams are left out. Each mark leads to the anchor
/// "finding-NUMBER". Marks that would cover each other are one, which names all.
/// `tones`: of the findings, from number 1.
std::string page_drawing(std::span<const SheetView> views, FindingTones tones);

} // namespace keiko
