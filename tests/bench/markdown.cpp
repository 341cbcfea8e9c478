#include "tests/bench/markdown.h"

#include "keiko/base/error.h"

#include "tests/bench/trace_tables.h"

#include <fstream>
#include <sstream>

namespace keiko::bench {

std::string markdown_of(const TraceResults& results) {
    std::string text = conditions_of(results) + ".\n";
    if (!results.skipped.empty()) {
        text += "\nSkipped, their files not being there:";
        for (const std::string& name : results.skipped) text += " " + name;
        text += ".\n";
    }
    return text + "\n" + markdown_of(summary_table(results));
}

void update_page(const std::filesystem::path& page, const std::string& group,
                 const std::string& tables) {
    std::ostringstream old;
    old << std::ifstream(page).rdbuf();
    const std::string text = old.str();
    const std::string begin_marker = "<!-- begin bench " + group + " -->\n";
    const std::string end_marker = "<!-- end bench " + group + " -->";
    const std::size_t begin = text.find(begin_marker), end = text.find(end_marker);
    if (begin == std::string::npos || end == std::string::npos || end < begin)
        throw Error(page.string(), "",
                    "has no markers '" + begin_marker.substr(0, begin_marker.size() - 1) +
                        "' and '" + end_marker + "'");
    std::ofstream out(page);
    out << text.substr(0, begin + begin_marker.size()) << "\n"
        << tables << "\n"
        << text.substr(end);
    if (!out.flush()) throw Error(page.string(), "", "cannot be written");
}

} // namespace keiko::bench
