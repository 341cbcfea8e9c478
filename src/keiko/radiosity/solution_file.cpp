#include "keiko/radiosity/solution_file.h"

#include "keiko/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

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

void read_corners(Reader& in, RadiositySolution& solution) {
    in.expect("corners");
    for (std::size_t left = in.count(6); left > 0; --left) {
        const double x = in.number(-most, most), y = in.number(-most, most);
        solution.corners.emplace_back(x, y, in.number(-most, most));
    }
}

void read_triangles(Reader& in, RadiositySolution& solution) {
    in.expect("triangles");
    const std::size_t count = in.count(30);
    if (count > 0 && solution.corners.empty()) throw in.error("has triangles without corners");
    const auto last = static_cast<std::uint32_t>(solution.corners.size() - 1);
    for (std::size_t t = 0; t < count; ++t) {
        auto& corners = solution.triangles.emplace_back();
        for (std::uint32_t& corner : corners) corner = in.number(std::uint32_t{0}, last);
        auto& light = solution.light.emplace_back();
        for (ElementLight& side : light) side.arriving = in.color(0), side.radiosity = in.color(0);
    }
}

} // namespace

std::string solution_text(const RadiositySolution& solution) {
    Writer out;
    out.word(format).end_line();
    out.word("geometry").word(solution.geometry).end_line();
    out.word("lighting").word(solution.lighting).end_line();
    out.word("remaining").number(solution.remaining).end_line();
    out.word("emitted").color(solution.balance.emitted).end_line();
    out.word("absorbed").color(solution.balance.absorbed).end_line();
    out.word("escaped").color(solution.balance.escaped).end_line();
    out.word("corners").number(solution.corners.size()).end_line();
    for (const Vec3& corner : solution.corners)
        out.number(corner.x).number(corner.y).number(corner.z).end_line();
    out.word("triangles").number(solution.triangles.size()).end_line();
    for (std::size_t t = 0; t < solution.triangles.size(); ++t) {
        for (const std::uint32_t corner : solution.triangles[t]) out.number(corner);
        for (const ElementLight& side : solution.light[t])
            out.color(side.arriving).color(side.radiosity);
        out.end_line();
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
    solution.balance.emitted = named_color(in, "emitted");
    solution.balance.absorbed = named_color(in, "absorbed");
    solution.balance.escaped = named_color(in, "escaped");
    read_corners(in, solution);
    read_triangles(in, solution);
    in.end();
    return solution;
}

} // namespace keiko
