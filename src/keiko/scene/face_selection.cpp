#include "keiko/scene/face_selection.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace keiko {
namespace {

/// sRGB transfer function [IEC61966-2-1] of a linear part from 0 to 1, in 255ths.
std::uint8_t encoded(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double shown = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * shown));
}

/// 0 to 15; nullopt for no digit.
std::optional<int> hexadecimal(char digit) {
    if (digit >= '0' && digit <= '9') return digit - '0';
    if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
    if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
    return std::nullopt;
}

void add(std::string& text, const std::string& words) {
    text += (text.empty() ? "" : ", ") + words;
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string corner(const Vec3& p) {
    return "(" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")";
}

} // namespace

FaceColor FaceColor::parse(std::string_view text) {
    constexpr std::size_t length = 7;
    const Error wrong("", "", "'" + shortened(text) + "' is no colour such as #c0c0c0");
    if (text.size() != length || text.front() != '#') throw wrong;
    FaceColor color;
    for (std::size_t i = 0; i < color.parts.size(); ++i) {
        const auto high = hexadecimal(text[2 * i + 1]), low = hexadecimal(text[2 * i + 2]);
        if (!high || !low) throw wrong;
        color.parts[i] = static_cast<std::uint8_t>(16 * *high + *low);
    }
    return color;
}

FaceColor FaceColor::of(const Rgb& linear) {
    return {{encoded(linear.r), encoded(linear.g), encoded(linear.b)}};
}

std::string FaceColor::text() const {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", parts[0], parts[1], parts[2]);
    return text;
}

std::string FaceSelection::text() const {
    std::string text;
    if (!faces.empty()) add(text, "faces " + comma_list(faces));
    if (!layers.empty()) add(text, "layers " + comma_list(layers));
    std::vector<std::string> shown;
    for (const FaceColor& color : colors) shown.push_back(color.text());
    if (!shown.empty()) add(text, "colors " + comma_list(shown));
    if (box) add(text, "box " + corner(box->lower) + " to " + corner(box->upper) + " mm");
    if (visible) add(text, "visible on at least " + number(100 * *visible) + " % of their area");
    return text;
}

bool FaceSelection::operator==(const FaceSelection& other) const {
    const bool same_box =
        box.has_value() == other.box.has_value() &&
        (!box || (box->lower == other.box->lower && box->upper == other.box->upper));
    return same_box && faces == other.faces && layers == other.layers && colors == other.colors &&
           visible == other.visible;
}

std::string Scope::text() const {
    std::string text = selection.text();
    if (!zones.empty()) add(text, (zones.size() == 1 ? "zone " : "zones ") + comma_list(zones));
    return text;
}

} // namespace keiko
