#include "keiko/stream/ray_lines.h"

#include "keiko/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keiko {
namespace {

constexpr std::size_t piece = 1 << 16; ///< bytes: some 700 rays
constexpr std::size_t fields = 6;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Reason why a line is no ray, and the field at fault.
struct Refusal {
    std::string_view field;
    std::string reason;
};

std::string_view without_blanks(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// True if a line is blank. If it ends with several '\r', only the last is the line's end; the
/// others are no fields either.
bool is_blank(std::string_view line) {
    return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

std::optional<std::string> read_number(std::string_view text, double& number) {
    if (text.empty()) return "is empty";
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (code == std::errc::result_out_of_range) return "is beyond all doubles: " + in_quotes(text);
    if (code != std::errc{} || end != text.data() + text.size())
        return "is not a number: " + in_quotes(text);
    if (!std::isfinite(number)) return "is not finite: " + in_quotes(text);
    return std::nullopt;
}

double largest_component(const Vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

std::string_view field_name(std::string_view header, std::size_t index) {
    for (; index > 0; --index) header.remove_prefix(header.find(',') + 1);
    return header.substr(0, header.find(','));
}

/// The names of the first three columns, and of the others.
std::string_view place_names(std::string_view header) {
    const std::string_view fourth = field_name(header, 3);
    return header.substr(0, static_cast<std::size_t>(fourth.data() - header.data()) - 1);
}
std::string_view direction_names(std::string_view header) {
    return header.substr(place_names(header).size() + 1);
}

/// Reason why a ray cannot be traced.
std::optional<Refusal> refusal_of(const Ray& ray, std::string_view header) {
    // Doubles beyond it are more than 0.1 mm apart.
    constexpr double farthest = 1e15;
    // Squares of values outside may overflow or underflow.
    constexpr double shortest = 1e-100, longest = 1e100;
    if (largest_component(ray.origin) > farthest)
        return Refusal{place_names(header), "lies beyond 1e15 mm"};
    const double length = largest_component(ray.direction);
    if (length == 0) return Refusal{direction_names(header), "is no direction: all are 0"};
    if (length < shortest || length > longest)
        return Refusal{direction_names(header), "has a length beyond 1e-100 to 1e100"};
    return std::nullopt;
}

/// True for an origin from which doubles do not resolve the intersection with a body.
bool is_far(const Ray& ray, const Box3& body) {
    constexpr double sizes = 1e8;
    return !body.empty() && !body.contains(ray.origin) &&
           std::max(ray.origin.length(), (ray.origin - body.center()).length()) >
               sizes * body.size();
}
constexpr std::string_view too_far = "is over 1e8 times the body's size away";

std::optional<Refusal> refusal_of(const Ray& ray, std::string_view header, const Box3& body) {
    if (!is_finite(ray.origin)) return Refusal{place_names(header), "is not finite"};
    if (!is_finite(ray.direction)) return Refusal{direction_names(header), "is not finite"};
    if (is_far(ray, body)) return Refusal{place_names(header), std::string(too_far)};
    return refusal_of(ray, header);
}

Refusal wrong_count(std::string_view line, std::size_t count, std::string_view header) {
    const std::string got = is_blank(line) ? "an empty line"
                            : count == 1   ? "1 field"
                                           : std::to_string(count) + " fields";
    return {"", "expected " + std::string(header) + ", got " + got};
}

std::optional<Refusal> read_ray(std::string_view line, std::string_view header, Ray& ray) {
    if (line.size() > longest_ray_line)
        return Refusal{"", "longer than " + std::to_string(longest_ray_line) + " characters"};
    const auto count = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
    if (count != fields) return wrong_count(line, count, header);
    std::array<double, 6> numbers{};
    for (std::size_t i = 0; i < fields; ++i) {
        const std::size_t end = std::min(line.find(','), line.size());
        if (auto reason = read_number(without_blanks(line.substr(0, end)), numbers[i]))
            return Refusal{field_name(header, i), std::move(*reason)};
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    ray.origin = Vec3(numbers[0], numbers[1], numbers[2]);
    ray.direction = Vec3(numbers[3], numbers[4], numbers[5]);
    return refusal_of(ray, header);
}

std::uint64_t newlines_in(std::string_view text) {
    return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
}

/// True if a line consists of the names of the header, with or without blanks around them.
bool names_columns(std::string_view line, std::string_view header) {
    if (std::count(line.begin(), line.end(), ',') != fields - 1) return false;
    for (std::size_t i = 0; i < fields; ++i)
        if (without_blanks(field_name(line, i)) != field_name(header, i)) return false;
    return true;
}

/// Start of the blank lines at the end of a text. A line that is too long is none of them.
std::size_t end_of_rays(std::string_view text) {
    while (!text.empty()) {
        std::string_view line = text;
        if (line.ends_with('\n')) line.remove_suffix(1);
        line.remove_prefix(line.rfind('\n') + 1);
        if (line.size() > longest_ray_line || !is_blank(line)) break;
        text = text.substr(0, static_cast<std::size_t>(line.data() - text.data()));
    }
    return text.size();
}

Error fault_at(std::uint64_t line, const Refusal& refusal) {
    const std::string field(refusal.field);
    return {"standard input", std::to_string(line),
            field.empty() ? refusal.reason : field + " " + refusal.reason};
}

} // namespace

/// Reads up to the end of a line; false if nothing is left.
bool RayLineReader::fill(std::string& text) {
    text.swap(rest_);
    rest_.clear();
    while (!ended_) {
        const std::size_t kept = text.size();
        text.resize(kept + piece);
        const std::size_t got = source_(std::span(text).subspan(kept));
        text.resize(kept + got);
        ended_ = got == 0;
        const std::size_t last = text.rfind('\n');
        if (last == std::string::npos && text.size() <= longest_ray_line) continue;
        if (last != std::string::npos && !ended_) {
            rest_.assign(text, last + 1);
            text.resize(last + 1);
        }
        break;
    }
    return !text.empty();
}

void RayLineReader::drop_header(RayLines& lines) {
    if (lines.text.starts_with(byte_order_mark)) lines.text.erase(0, byte_order_mark.size());
    const std::size_t end = lines.text.find('\n');
    std::string_view line = std::string_view(lines.text).substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!names_columns(line, header_)) return;
    lines.text.erase(0, end == std::string::npos ? end : end + 1);
    lines.first_line = 2;
}

/// Holds blank lines back until it is known whether a ray follows; the first of many is enough.
void RayLineReader::hold_blank_lines(RayLines& lines) {
    const std::size_t end = end_of_rays(lines.text);
    const std::uint64_t held =
        lines.first_line + newlines_in(std::string_view(lines.text).substr(0, end));
    const bool holds = end < lines.text.size();
    lines.text.resize(end);
    if (blank_line_ && end > 0) {
        lines.text.insert(0, 1, '\n');
        lines.first_line = *blank_line_;
    }
    if (holds && !blank_line_) blank_line_ = held;
}

bool RayLineReader::read(RayLines& lines) {
    if (!fill(lines.text)) return false;
    lines.first_line = next_line_, lines.first_ray = next_ray_;
    if (next_line_ == 1) drop_header(lines);
    next_line_ = lines.first_line + newlines_in(lines.text);
    hold_blank_lines(lines);
    next_ray_ += newlines_in(lines.text);
    return true;
}

ParsedRays rays_of(const RayLines& lines, std::string_view header) {
    ParsedRays parsed;
    std::string_view text = lines.text;
    for (std::uint64_t number = lines.first_line; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        Ray ray;
        if (const auto refusal = read_ray(line, header, ray)) {
            parsed.fault = fault_at(number, *refusal);
            break;
        }
        parsed.rays.push_back(ray);
    }
    return parsed;
}

void require_rays(std::span<const Ray> rays, const std::string& field, const Box3& body,
                  std::string_view header) {
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (const auto refusal = refusal_of(rays[i], header, body))
            throw FieldError(field + "[" + std::to_string(i) + "]",
                             std::string(refusal->field) + " " + refusal->reason);
}

void end_before(ParsedRays& parsed, const RayLines& lines, std::size_t ray,
                const std::string& reason, std::string_view header) {
    parsed.fault = fault_at(lines.first_line + ray, {place_names(header), reason});
    parsed.rays.resize(ray);
}

void end_before_far_origins(ParsedRays& parsed, const RayLines& lines, const Box3& body) {
    const auto far = std::find_if(parsed.rays.begin(), parsed.rays.end(),
                                  [&](const Ray& ray) { return is_far(ray, body); });
    if (far == parsed.rays.end()) return;
    end_before(parsed, lines, static_cast<std::size_t>(far - parsed.rays.begin()),
               std::string(too_far));
}

} // namespace keiko
