#include "keiko/files/toml/toml_text.h"

#include "keiko/base/error.h"

#include <array>
#include <charconv>
#include <cmath>

namespace keiko {

std::string toml_number(double value) {
    char buffer[32];
    const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value).ptr;
    std::string text(buffer, end);
    // Without a point TOML reads an integer, which has no -0 and ends at 2^63.
    const bool whole = text.find_first_of(".e") == std::string::npos;
    const bool no_integer = text == "-0" || std::abs(value) > 1e15;
    return whole && no_integer ? text + ".0" : text;
}

std::string toml_value(double value) {
    if (!std::isfinite(value)) throw Error("", "rig", "holds a number that is not finite");
    return toml_number(value);
}

std::string toml_value(std::span<const double> numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : ", ") + toml_value(number);
    return "[" + text + "]";
}

std::string toml_value(const Vec3& v) {
    return toml_value(std::array{v.x, v.y, v.z});
}

std::string toml_value(const Rgb& c) {
    return c.r == c.g && c.g == c.b ? toml_value(c.r) : toml_value(std::array{c.r, c.g, c.b});
}

std::string toml_string(std::string_view text) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f) {
            result += {'\\', 'u', '0', '0', digits[code >> 4], digits[code & 15]};
            continue;
        }
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

std::string toml_line(std::string_view key, const std::string& value, std::string_view comment) {
    std::string text = std::string(key) + " = " + value;
    if (!comment.empty()) text += " # " + std::string(comment);
    return text + "\n";
}

std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
    return (folder.empty() ? file : file.lexically_proximate(folder)).generic_string();
}

} // namespace keiko
