#include "keiko/base/error.h"
#include "keiko/files/scan/scan_formats.h"
#include "keiko/files/scan/text_lines.h"

namespace keiko {
namespace {

constexpr std::string_view blanks = " \t,;";

/// A line without its comment.
std::string_view without_comment(std::string_view line) {
    return line.substr(0, std::min(line.find('#'), line.find("//")));
}

/// True for what may stand before the points: words, or a count alone.
bool is_heading(std::string_view line) {
    const std::string_view first = take_word(line, blanks);
    return !number_in(first) || take_word(line, blanks).empty();
}

} // namespace

std::vector<Vec3> column_points(std::string_view bytes, const std::string& file) {
    std::vector<Vec3> points;
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
    LineReader lines(bytes);
    int headings = 0;
    while (const auto whole = lines.next()) {
        std::string_view line = without_comment(*whole);
        if (line.find_first_not_of(blanks) == std::string_view::npos) continue;
        if (line.find(';') != std::string_view::npos && line.find(',') != std::string_view::npos)
            throw Error(file, std::to_string(lines.number()),
                        "has ';' and ',': numbers with a decimal comma are not read");
        if (points.empty() && headings < 2 && is_heading(line)) {
            ++headings;
            continue;
        }
        Vec3 point(0);
        for (unsigned k = 0; k < 3; ++k) {
            const std::string_view word = take_word(line, blanks);
            const auto number = number_in(word);
            if (!number)
                throw Error(file, std::to_string(lines.number()),
                            word.empty() ? "a point has three numbers"
                                         : "not a number: " + in_quotes(word));
            point[k] = *number;
        }
        points.push_back(point);
    }
    return points;
}

} // namespace keiko
