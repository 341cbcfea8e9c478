#include "keiko/drawing/sheet/sheet.h"

#include <algorithm>

namespace keiko {

SheetLayer& layer_of(Sheet& sheet, const std::string& name, double width, bool dashed) {
    const auto found = std::find_if(sheet.layers.begin(), sheet.layers.end(),
                                    [&](const SheetLayer& layer) { return layer.name == name; });
    if (found != sheet.layers.end()) return *found;
    sheet.layers.push_back({name, width, dashed});
    return sheet.layers.back();
}

} // namespace keiko
