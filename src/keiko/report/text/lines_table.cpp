#include "keiko/base/text.h"
#include "keiko/report/json/lines_json.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace keiko {
namespace {

/// A number without the sign of one that is rounded to 0.
std::string number(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    if (std::strtod(text, nullptr) == 0) std::snprintf(text, sizeof text, format, 0.0);
    return text;
}

/// Right-aligned numbers, then the names, which may be long.
std::string row_text(std::size_t rank, const LineCrossing& c, const std::string& view) {
    const auto known = [&](const char* format, const LineValue& value) {
        return c.continued() ? number(format, value.value) : std::string("-");
    };
    char text[256];
    std::snprintf(
        text, sizeof text, "%3zu  %-9s %8s %9s %8s %8s %9s %9s  %5s  (%.1f, %.1f, %.1f)  ", rank,
        std::string(name_of(*c.verdict)).c_str(), number("%.3g", c.severity).c_str(),
        number("%.4f", c.plane_jump).c_str(), number("%.4f", c.turn.value).c_str(),
        known("%.4f", c.jump).c_str(), known("%.4f", c.kink).c_str(), known("%.2e", c.bend).c_str(),
        (std::to_string(c.plane) + "." + std::to_string(c.lamp)).c_str(), c.place.x, c.place.y,
        c.place.z);
    return text + c.faces + " in " + view;
}

} // namespace

std::string crossings_table(const LineList& list, std::size_t most) {
    const std::vector<CrossingPlace> ranked = ranked_crossings(list);
    if (ranked.empty()) return "";
    TextLines lines;
    lines.line()
        << "  #  verdict   severity  plane mm   turn °  jump mm    kink ° bend 1/mm   lamp  "
           "place";
    for (std::size_t i = 0; i < std::min(ranked.size(), most); ++i)
        lines.line() << row_text(i + 1, ranked[i].in(list), list.views[ranked[i].view].view);
    if (ranked.size() > most)
        lines.line() << "... and " << ranked.size() - most << " crossings less bad";
    return lines.text();
}

} // namespace keiko
