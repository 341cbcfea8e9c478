#include "keiko/stream/hit_columns.h"

#include "keiko/base/error.h"
#include "keiko/geometry/bezier/differential_geometry.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

constexpr std::array<std::string_view, 20> names{
    "t",  "instance", "face", "patch", "u",     "v",     "x",         "y", "z", "nx",
    "ny", "nz",       "k1",   "k2",    "bound", "flags", "luminance", "r", "g", "b"};

std::string_view name_of(HitColumn column) {
    return names[static_cast<std::size_t>(column)];
}

HitColumn column_named(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<HitColumn>(found - names.begin());
    std::string known;
    for (const std::string_view one : names) known += (known.empty() ? "" : ",") + std::string(one);
    throw FieldError("columns",
                     "no column is called \"" + std::string(name) + "\"; there are " + known);
}

template <class Number>
void append_digits(std::string& text, Number number) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    text.append(digits.data(), end);
}

void append_value(std::string& text, double number) {
    if (std::isfinite(number)) append_digits(text, number);
}

void append_field(std::string& text, HitColumn column, const Hit& hit,
                  const PrincipalCurvatures& bent, const Rgb& seen) {
    switch (column) {
        case HitColumn::t:
            return append_value(text, hit.t);
        case HitColumn::instance:
            return append_digits(text, hit.instance);
        case HitColumn::face:
            return append_digits(text, hit.face);
        case HitColumn::patch:
            return append_digits(text, hit.patch);
        case HitColumn::u:
            return append_value(text, hit.uv.x);
        case HitColumn::v:
            return append_value(text, hit.uv.y);
        case HitColumn::x:
            return append_value(text, hit.position.x);
        case HitColumn::y:
            return append_value(text, hit.position.y);
        case HitColumn::z:
            return append_value(text, hit.position.z);
        case HitColumn::nx:
            return append_value(text, hit.normal.x);
        case HitColumn::ny:
            return append_value(text, hit.normal.y);
        case HitColumn::nz:
            return append_value(text, hit.normal.z);
        case HitColumn::k1:
            return append_value(text, bent.k1);
        case HitColumn::k2:
            return append_value(text, bent.k2);
        case HitColumn::bound:
            return append_value(text, hit.position_bound);
        case HitColumn::flags:
            text += flag_words(hit.flags);
            return;
        case HitColumn::luminance:
            return append_value(text, luminance(seen));
        case HitColumn::r:
            return append_value(text, seen.r);
        case HitColumn::g:
            return append_value(text, seen.g);
        case HitColumn::b:
            return append_value(text, seen.b);
    }
}

} // namespace

std::vector<HitColumn> hit_columns(std::string_view list) {
    std::vector<HitColumn> columns;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string_view name = list.substr(begin, end - begin);
        const HitColumn column = column_named(name);
        if (std::find(columns.begin(), columns.end(), column) != columns.end())
            throw FieldError("columns",
                             "the column \"" + std::string(name) + "\" stands there twice");
        columns.push_back(column);
        begin = end + 1;
    }
    return columns;
}

std::optional<std::string> light_column(const std::vector<HitColumn>& columns) {
    for (const HitColumn column : columns)
        if (column >= HitColumn::luminance) return std::string(name_of(column));
    return std::nullopt;
}

std::string header_of(const std::vector<HitColumn>& columns) {
    std::string text;
    for (const HitColumn column : columns) {
        if (!text.empty()) text += ',';
        text += name_of(column);
    }
    return text;
}

std::string flag_words(HitFlags flags) {
    std::string words = has(flags, HitFlags::clipped) ? "clipped" : "";
    if (has(flags, HitFlags::tangential)) words += words.empty() ? "tangential" : "|tangential";
    if (words.empty()) words = "unique";
    if (has(flags, HitFlags::seam)) words += "|seam";
    return words;
}

void append_row(std::string& text, const std::vector<HitColumn>& columns, const Hit& hit,
                const Rgb& luminance) {
    const bool asks_curvature = std::any_of(columns.begin(), columns.end(), [](HitColumn c) {
        return c == HitColumn::k1 || c == HitColumn::k2;
    });
    const PrincipalCurvatures bent = asks_curvature ? curvatures_of(hit) : PrincipalCurvatures{};
    for (const HitColumn column : columns) {
        append_field(text, column, hit, bent, luminance);
        text += ',';
    }
    text.back() = '\n';
}

void append_empty_row(std::string& text, const std::vector<HitColumn>& columns) {
    text.append(columns.size() - 1, ',');
    text += '\n';
}

PrincipalCurvatures curvatures_of(const Hit& hit) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const PrincipalCurvatures none{unknown, unknown};
    return hit.second ? reliable_curvatures(derivatives_of(hit), hit.normal).value_or(none) : none;
}

void append_number(std::string& text, std::uint64_t number) {
    append_digits(text, number);
}

void append_number(std::string& text, double number) {
    append_digits(text, number);
}

} // namespace keiko
