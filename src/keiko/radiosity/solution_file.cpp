#include "keiko/radiosity/solution_file.h"

#include "keiko/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace keiko {
namespace {

constexpr std::string_view format = "keiko-solution/1";
/// Largest size of a coordinate in mm, and of light.
constexpr double most = 1e15;

class Writer {
public:
    Writer& word(std::string_view text) {
        if (!text_.empty() && text_.back() != '\n') text_ += ' ';
        text_ += text;
        return *this;
    }
    template <class Number>
    Writer& number(Number value) {
        constexpr std::size_t longest = 32;
        std::array<char, longest> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + longest, value).ptr;
        return word({digits.data(), static_cast<std::size_t>(end - digits.data())});
    }
    Writer& color(const Rgb& c) { return number(c.r).number(c.g).number(c.b); }
    /// A colour of light, in single precision.
    Writer& light(const Rgb& c) {
        const auto rounded = [](double x) { return static_cast<float>(x); };
        return number(rounded(c.r)).number(rounded(c.g)).number(rounded(c.b));
    }
    void end_line() { text_ += '\n'; }
    std::string taken() { return std::move(text_); }

private:
    std::string text_;
};

/// Words of a text, which are separated by blanks and ends of lines.
class Reader {
public:
    Reader(std::string_view text, const std::string& source) : rest_(text), source_(source) {}

    std::string_view word() {
        skip_blanks();
        const std::size_t end = std::min(rest_.find_first_of(" \n"), rest_.size());
        const std::string_view found = rest_.substr(0, end);
        rest_.remove_prefix(end);
        if (found.empty()) throw error("ends here, too early");
        return found;
    }
    void expect(std::string_view wanted) {
        if (const std::string_view found = word(); found != wanted)
            throw error("expected " + in_quotes(wanted) + ", found " +
                        in_quotes(shortened(found, 40)));
    }
    /// A number from `least` to `largest`.
    template <class Number>
    Number number(Number least, Number largest) {
        const std::string_view digits = word();
        Number value{};
        const auto [end, fault] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (fault != std::errc() || end != digits.data() + digits.size() ||
            !(value >= least && value <= largest))
            throw error(in_quotes(shortened(digits, 40)) + " is no number from " + text_of(least) +
                        " to " + text_of(largest));
        return value;
    }
    Rgb color(double least) {
        const double r = number(least, most), g = number(least, most), b = number(least, most);
        return {r, g, b};
    }
    /// A colour of light, in single precision.
    Rgb light() {
        const auto channel = [&] { return number(0.0F, static_cast<float>(most)); };
        const float r = channel(), g = channel();
        return {r, g, channel()};
    }
    /// Number of lines that follow, each of at least `bytes`.
    std::size_t count(std::size_t bytes) { return number(std::size_t{0}, rest_.size() / bytes); }
    void end() {
        skip_blanks();
        if (!rest_.empty()) throw error("goes on after its end");
    }
    Error error(const std::string& reason) const {
        return {source_, "line " + std::to_string(line_), reason};
    }

private:
    template <class Number>
    static std::string text_of(Number value) {
        return Writer().number(value).taken();
    }
    void skip_blanks() {
        while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\n')) {
            if (rest_[0] == '\n') ++line_;
            rest_.remove_prefix(1);
        }
    }

    std::string_view rest_;
    const std::string& source_;
    std::size_t line_ = 1;
};

std::string hash_from(Reader& in, std::string_view name) {
    in.expect(name);
    const std::string_view digits = in.word();
    constexpr std::size_t length = 64;
    if (digits.size() != length ||
        digits.find_first_not_of("0123456789abcdef") != std::string_view::npos)
        throw in.error(std::string(name) + " is no SHA-256");
    return std::string(digits);
}

Rgb named_color(Reader& in, std::string_view name) {
    in.expect(name);
    return in.color(-most);
}

/// Bytes that a number and the blank after it take at least.
constexpr std::size_t least_digits = 2;

void read_corners(Reader& in, RadiositySolution& solution) {
    in.expect("corners");
    for (std::size_t left = in.count(2 * least_digits); left > 0; --left) {
        const double u = in.number(-most, most);
        solution.corners.emplace_back(u, in.number(-most, most));
    }
}

void read_triangles(Reader& in, RadiositySolution& solution) {
    in.expect("elements");
    solution.elements = in.count(1);
    in.expect("triangles");
    const std::size_t count = in.count(6 * least_digits);
    if (count > 0 && (solution.corners.empty() || solution.elements == 0))
        throw in.error("has triangles without corners or elements");
    const auto last = static_cast<std::uint32_t>(solution.corners.size() - 1);
    const auto last_element = static_cast<std::uint32_t>(solution.elements - 1);
    for (std::size_t t = 0; t < count; ++t) {
        SolvedTriangle& triangle = solution.triangles.emplace_back();
        for (std::uint32_t& corner : triangle.corners) corner = in.number(0U, last);
        triangle.element = in.number(0U, last_element);
        constexpr std::uint32_t any = std::numeric_limits<std::uint32_t>::max();
        triangle.instance = in.number(0U, any);
        triangle.face = in.number(0U, any);
    }
}

std::vector<BothSides> read_light(Reader& in, std::string_view name, std::size_t count) {
    in.expect(name);
    std::vector<BothSides> light;
    for (std::size_t i = 0; i < count; ++i)
        for (BothSides& both = light.emplace_back(); Rgb & side : both) side = in.light();
    return light;
}

void write_light(Writer& out, std::string_view name, std::span<const BothSides> light) {
    out.word(name).end_line();
    for (const BothSides& both : light) {
        for (const Rgb& side : both) out.light(side);
        out.end_line();
    }
}

} // namespace

std::string solution_text(const RadiositySolution& solution) {
    Writer out;
    out.word(format).end_line();
    out.word("geometry").word(solution.geometry).end_line();
    out.word("lighting").word(solution.lighting).end_line();
    out.word("remaining").number(solution.remaining).end_line();
    out.word("rows").number(solution.factor_rows).end_line();
    out.word("element").number(solution.element_size).end_line();
    out.word("emitted").color(solution.balance.emitted).end_line();
    out.word("absorbed").color(solution.balance.absorbed).end_line();
    out.word("escaped").color(solution.balance.escaped).end_line();
    out.word("corners").number(solution.corners.size()).end_line();
    for (const Vec2& corner : solution.corners) out.number(corner.x).number(corner.y).end_line();
    out.word("elements").number(solution.elements).end_line();
    out.word("triangles").number(solution.triangles.size()).end_line();
    for (const SolvedTriangle& t : solution.triangles) {
        for (const std::uint32_t corner : t.corners) out.number(corner);
        out.number(t.element).number(t.instance).number(t.face).end_line();
    }
    out.word("lamps").number(solution.lamps.size()).end_line();
    for (const LampSolution& lamp : solution.lamps) {
        write_light(out, "arriving", lamp.arriving);
        write_light(out, "exitance", lamp.exitance);
    }
    return out.taken();
}

RadiositySolution parse_solution(std::string_view text, const std::string& source) {
    Reader in(text, source);
    in.expect(format);
    RadiositySolution solution;
    solution.geometry = hash_from(in, "geometry");
    solution.lighting = hash_from(in, "lighting");
    in.expect("remaining");
    solution.remaining = in.number(0.0, most);
    in.expect("rows");
    solution.factor_rows = in.number(std::size_t{0}, std::numeric_limits<std::size_t>::max());
    in.expect("element");
    solution.element_size = in.number(0.0, most);
    solution.balance.emitted = named_color(in, "emitted");
    solution.balance.absorbed = named_color(in, "absorbed");
    solution.balance.escaped = named_color(in, "escaped");
    read_corners(in, solution);
    read_triangles(in, solution);
    in.expect("lamps");
    for (std::size_t left = in.count(1); left > 0; --left) {
        LampSolution& lamp = solution.lamps.emplace_back();
        lamp.arriving = read_light(in, "arriving", solution.corners.size());
        lamp.exitance = read_light(in, "exitance", solution.elements);
    }
    in.end();
    return solution;
}

} // namespace keiko
