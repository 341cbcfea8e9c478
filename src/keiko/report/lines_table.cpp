#include "keiko/report/lines_json.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace keiko {
namespace {

struct Row {
    const ViewLines* view;
    const LineCrossing* crossing;
};

/// Of all views, worst first.
std::vector<Row> judged_crossings(const LineList& list) {
    std::vector<Row> rows;
    for (const ViewLines& view : list.views)
        for (const LineCrossing& crossing : view.found.crossings)
            if (crossing.verdict) rows.push_back({&view, &crossing});
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        if (*a.crossing->verdict != *b.crossing->verdict)
            return *a.crossing->verdict > *b.crossing->verdict;
        return a.crossing->severity > b.crossing->severity;
    });
    return rows;
}

std::string number(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Right-aligned numbers, then the names, which may be long.
std::string row_text(const Row& row) {
    const LineCrossing& c = *row.crossing;
    const auto known = [&](const char* format, const LineValue& value) {
        return c.continued() ? number(format, std::abs(value.value)) : std::string("-");
    };
    char text[256];
    std::snprintf(text, sizeof text, "%-9s %8s %9s %8s %8s %9s %9s  %5s  (%.1f, %.1f, %.1f)  ",
                  std::string(name_of(*c.verdict)).c_str(), number("%.3g", c.severity).c_str(),
                  number("%.4f", std::abs(c.plane_jump)).c_str(),
                  number("%.4f", std::abs(c.turn.value)).c_str(), known("%.4f", c.jump).c_str(),
                  known("%.4f", c.kink).c_str(), known("%.2e", c.bend).c_str(),
                  (std::to_string(c.plane) + "." + std::to_string(c.lamp)).c_str(), c.place.x,
                  c.place.y, c.place.z);
    return text + c.faces + " in " + row.view->view + "\n";
}

} // namespace

std::string crossings_table(const LineList& list, std::size_t most) {
    const std::vector<Row> rows = judged_crossings(list);
    if (rows.empty()) return "";
    std::string text =
        "verdict   severity  plane mm   turn °  jump mm    kink ° bend 1/mm   lamp  place\n";
    for (std::size_t i = 0; i < std::min(rows.size(), most); ++i) text += row_text(rows[i]);
    if (rows.size() > most)
        text += "... and " + std::to_string(rows.size() - most) + " crossings less bad\n";
    return text;
}

} // namespace keiko
