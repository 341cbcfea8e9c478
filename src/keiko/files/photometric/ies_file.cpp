#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/photometric/luminaire_file.h"

#include <cmath>
#include <utility>

namespace keiko {
namespace {

constexpr std::size_t most_lamps = 10'000;
constexpr double mm_per_foot = 304.8, mm_per_metre = 1000;

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// A text taken line by line, or number by number: blanks, commas and line ends part numbers.
class IesText {
public:
    IesText(std::string_view text, const std::filesystem::path& source)
        : text_(text), source_(source) {}

    PhotometricPlace place() const { return {source_, line_}; }
    bool at_end() const { return text_.empty(); }

    std::string_view line() {
        const std::size_t end = std::min(text_.find('\n'), text_.size());
        const std::string_view line = text_.substr(0, end);
        text_.remove_prefix(std::min(end + 1, text_.size()));
        ++line_;
        return trimmed(line);
    }

    double number(const char* wanted) {
        skip_blanks();
        if (text_.empty()) place().fail(std::string("the file ends before ") + wanted);
        const std::string_view word = text_.substr(0, text_.find_first_of(blanks));
        text_.remove_prefix(word.size());
        return place().number(word, wanted);
    }
    double number_from(double low, const char* wanted) {
        const double value = number(wanted);
        if (!(value >= low)) place().fail(std::string(wanted) + " is too small");
        return value;
    }
    double positive(const char* wanted) {
        const double value = number(wanted);
        if (!(value > 0)) place().fail(std::string(wanted) + " must be above 0");
        return value;
    }
    /// A whole number; no count can be larger than what is left of the file.
    std::size_t count(std::size_t least, const char* wanted) {
        const double value = number(wanted);
        const std::size_t most = text_.size() / 2 + 1;
        if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) ||
            value != std::floor(value))
            place().fail(std::string(wanted) + " is no count that the file can hold");
        return static_cast<std::size_t>(value);
    }
    std::size_t choice(std::size_t most, const char* wanted) {
        const double value = number(wanted);
        if (!(value >= 1 && value <= static_cast<double>(most)) || value != std::floor(value))
            place().fail(std::string(wanted) + " must be from 1 to " + std::to_string(most));
        return static_cast<std::size_t>(value);
    }
    std::vector<double> numbers(std::size_t n, const char* wanted) {
        std::vector<double> values;
        for (std::size_t i = 0; i < n; ++i) values.push_back(number(wanted));
        return values;
    }
    void expect_end() {
        skip_blanks();
        if (!text_.empty()) place().fail("more numbers than the counts say");
    }

private:
    /// The last is what DOS ends a text with.
    static constexpr std::string_view blanks = " \t\r\n,\x1a";

    void skip_blanks() {
        if (line_begins_) ++line_, line_begins_ = false;
        while (!text_.empty() && blanks.find(text_.front()) != std::string_view::npos) {
            if (text_.front() == '\n') ++line_;
            text_.remove_prefix(1);
        }
    }

    std::string_view text_;
    const std::filesystem::path& source_;
    std::size_t line_ = 0;
    bool line_begins_ = true; ///< no number of the line after the last taken whole was read yet
};

/// The value of a line "[KEY] value", or nothing for other lines.
std::string_view value_of(std::string_view line, std::string_view key) {
    if (!line.starts_with(key)) return {};
    return trimmed(line.substr(key.size()));
}

/// Lamps that are sensitive to it lose or gain light when the luminaire is tilted: the factor
/// where it is not.
double upright_factor(IesText& in) {
    in.choice(3, "the lamp's position in a tilted luminaire");
    const std::size_t n = in.count(1, "the number of tilt angles");
    const std::vector<double> angles = in.numbers(n, "a tilt angle");
    require_ascending(in.place(), angles, 0, 180, "tilt angles");
    if (angles.front() != 0) in.place().fail("tilt angles must begin with 0");
    const std::vector<double> factors = in.numbers(n, "a tilt factor");
    for (const double factor : factors)
        if (!(factor >= 0)) in.place().fail("a tilt factor must not be negative");
    return factors.front();
}

double tilt_factor(IesText& in, std::string_view tilt, const std::filesystem::path& source) {
    if (tilt == "NONE") return 1;
    if (tilt == "INCLUDE") return upright_factor(in);
    // A luminaire file must not lead to files elsewhere.
    if (tilt.empty() || tilt.size() > 200 || tilt.find_first_of("/\\:") != std::string_view::npos)
        in.place().fail("TILT= must be followed by NONE, INCLUDE or the name of a file beside it");
    for (const char c : tilt)
        if (static_cast<unsigned char>(c) < ' ') in.place().fail("TILT= names no file");
    const std::filesystem::path file = source.parent_path() / tilt;
    const std::string text = read_text_file(file);
    IesText factors(text, file);
    const double factor = upright_factor(factors);
    factors.expect_end();
    return factor;
}

/// mm: the length lies along H = 0, the width across.
Vec3 opening_of(IesText& in) {
    const double unit =
        in.choice(2, "the unit (1: feet, 2: metres)") == 1 ? mm_per_foot : mm_per_metre;
    const double width = in.number("the opening's width");
    const double length = in.number("the opening's length");
    const double height = in.number("the opening's height");
    // Negative ones denote round shapes; a circle has a width alone.
    const double along = width < 0 && length == 0 ? width : length;
    return Vec3(std::abs(along), std::abs(width), std::abs(height)) * unit;
}

IntensityTable table_of(IesText& in, PhotometricType type, std::size_t verticals,
                        std::size_t horizontals, double factor) {
    const bool c = type == PhotometricType::c;
    std::vector<double> v = in.numbers(verticals, "a vertical angle");
    require_ascending(in.place(), v, c ? 0 : -90, c ? 180 : 90, "vertical angles");
    std::vector<double> h = in.numbers(horizontals, "a horizontal angle");
    require_ascending(in.place(), h, c ? 0 : -90, c ? 360 : 90, "horizontal angles");
    auto symmetry = symmetry_of_planes(h);
    if (!c) symmetry = h.front() == 0 ? PlaneSymmetry::lateral : PlaneSymmetry::limited;
    if (!c && h.size() < 2) in.place().fail("types A and B need two horizontal angles or more");
    if (!symmetry) in.place().fail("no symmetry completes these horizontal angles to a full turn");
    std::vector<double> candela = in.numbers(verticals * horizontals, "an intensity");
    for (double& value : candela) {
        if (!(value >= 0)) in.place().fail("an intensity must not be negative");
        value *= factor;
    }
    return {std::move(v), std::move(h), std::move(candela), *symmetry};
}

} // namespace

PhotometricWeb parse_ies(std::string_view text, const std::filesystem::path& source) {
    IesText in(text, source);
    std::string name, number_of_maker;
    std::string_view line;
    while (!(line = in.line()).starts_with("TILT=")) {
        if (in.at_end()) in.place().fail("there is no line TILT=, as every IES LM-63 file has");
        if (name.empty()) name = one_line(value_of(line, "[LUMINAIRE]"));
        if (number_of_maker.empty()) number_of_maker = one_line(value_of(line, "[LUMCAT]"));
    }
    if (name.empty()) name = number_of_maker;
    const double tilt = tilt_factor(in, trimmed(line.substr(5)), source);
    const double lamps = static_cast<double>(in.choice(most_lamps, "the number of lamps"));
    const double lumens = in.number("the lumens of a lamp");
    if (lumens < 0 && lumens != -1)
        in.place().fail("the lumens of a lamp must be -1, for absolute values, or not negative");
    const double multiplier = in.positive("the multiplier");
    const std::size_t verticals = in.count(2, "the number of vertical angles");
    const std::size_t horizontals = in.count(1, "the number of horizontal angles");
    constexpr PhotometricType types[] = {PhotometricType::c, PhotometricType::b,
                                         PhotometricType::a};
    const PhotometricType type = types[in.choice(3, "the photometric type") - 1];
    const Vec3 opening = opening_of(in);
    const double ballast = in.positive("the ballast factor");
    const double lamp_factor = in.positive("the ballast-lamp factor");
    in.number_from(0, "the input power");
    IntensityTable table =
        table_of(in, type, verticals, horizontals, multiplier * ballast * lamp_factor * tilt);
    in.expect_end();
    return {.type = type,
            .candela = std::move(table),
            .name = name,
            .lamp_flux = lumens > 0 ? lamps * lumens : 0,
            .opening = opening};
}

} // namespace keiko
