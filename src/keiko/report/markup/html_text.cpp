#include "keiko/report/markup/html_text.h"

#include "keiko/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace keiko {
namespace {

void append_escaped(std::string& result, char c) {
    switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
    }
}

std::string formatted(const char* format, int precision, double value) {
    char text[400]; // holds the largest double with all its digits
    std::snprintf(text, sizeof text, format, precision, value);
    return text;
}

/// A coordinate with one decimal. + 0.0 turns a negative zero into a positive one.
std::string coordinate(double x) {
    return formatted("%.*f", 1, std::round(x * 10) / 10 + 0.0);
}

} // namespace

std::string html_escaped(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 1)
            append_escaped(result, text.front());
        else
            result += length == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::string fixed_number(double value, int decimals) {
    if (!std::isfinite(value)) return "–";
    const double last = std::pow(10.0, -decimals);
    if (value != 0 && std::abs(value) < last / 2) return "< " + formatted("%.*f", decimals, last);
    return formatted("%.*f", decimals, value);
}

std::string html_bar(double share) {
    const double width = share > 0 ? 100 * std::min(share, 1.0) : 0;
    return "<div class=\"bar\"><i style=\"width:" + formatted("%.*f", 2, width) + "%\"></i></div>";
}

std::string short_number(double value, int digits) {
    return std::isfinite(value) ? formatted("%.*g", digits, value) : "–";
}

std::string place_text(const Vec3& place) {
    return coordinate(place.x) + ", " + coordinate(place.y) + ", " + coordinate(place.z);
}

std::string place_with_axes(const Vec3& place) {
    return "x " + coordinate(place.x) + ", y " + coordinate(place.y) + ", z " +
           coordinate(place.z) + " mm";
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string html_table_head(const std::vector<std::string>& names,
                            const std::vector<std::string>& left) {
    std::string html = "<div class=\"card scroll\"><table><thead><tr>";
    for (const std::string& name : names) {
        const bool is_left = std::find(left.begin(), left.end(), name) != left.end();
        html += std::string(is_left ? "<th class=\"left\">" : "<th>") + "<button type=\"button\">" +
                name + "</button></th>";
    }
    return html + "</tr></thead><tbody>\n";
}

std::string html_cell(const std::string& sort_key, const std::string& text,
                      std::string_view classes) {
    const std::string named = classes.empty() ? "" : " class=\"" + std::string(classes) + "\"";
    return "<td" + named + " data-v=\"" + sort_key + "\">" + text + "</td>";
}

std::string html_words_cell(const std::string& text) {
    const std::string escaped = html_escaped(text);
    return html_cell(escaped, escaped, "left");
}

std::string html_place_cell(const Vec3& place) {
    return html_cell(short_number(place.x, 9), place_text(place));
}

std::string html_number_cell(double value, const std::string& text, bool over) {
    return html_cell(short_number(value, 9), text, over ? "tone" : "");
}

std::string html_plain_table(const std::vector<std::string>& headings, const std::string& rows) {
    std::string html = "<div class=\"card scroll\"><table><thead><tr>";
    for (const std::string& heading : headings) {
        const bool left = heading.starts_with("<");
        html += std::string("<th") + (left ? " class=\"left\"" : "") + ">" +
                html_escaped(left ? heading.substr(1) : heading) + "</th>";
    }
    return html + "</tr></thead><tbody>" + rows + "</tbody></table></div>\n";
}

std::string html_text_cell(const std::string& text, bool left) {
    return std::string(left ? "<td class=\"left\">" : "<td>") + html_escaped(text) + "</td>";
}

} // namespace keiko
