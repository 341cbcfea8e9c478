#include "keiko/import/subdivision/cage_statements.h"

#include "keiko/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keiko::subdivision {

namespace {

std::string_view without_plus(std::string_view word) {
    return word.starts_with('+') ? word.substr(1) : word;
}

template <class Number>
bool read_whole_word(std::string_view word, Number& value) {
    const std::string_view digits = without_plus(word);
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return code == std::errc() && end == digits.data() + digits.size();
}

} // namespace

bool CageLines::next(Statement& statement) {
    statement.words.clear();
    bool continued = false;
    while (position_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', position_), text_.size());
        std::string_view line = std::string_view(text_).substr(position_, end - position_);
        position_ = end + 1;
        ++line_;
        if (statement.words.empty()) statement.line = line_;
        line = line.substr(0, line.find('#'));
        const std::size_t last = line.find_last_not_of(" \t\r");
        continued = last != std::string_view::npos && line[last] == '\\';
        append_words(continued ? line.substr(0, last) : line, statement);
        if (!continued && !statement.words.empty()) return true;
    }
    return !statement.words.empty();
}

void CageLines::append_words(std::string_view line, Statement& statement) const {
    constexpr std::string_view blanks = " \t\r\f\v";
    while (true) {
        const std::size_t begin = line.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return;
        line.remove_prefix(begin);
        const std::size_t size = std::min(line.find_first_of(blanks), line.size());
        statement.words.push_back(line.substr(0, size));
        line.remove_prefix(size);
    }
}

double CageLines::number(const Statement& statement, std::string_view word) const {
    double value = 0;
    if (!read_whole_word(word, value) || !std::isfinite(value))
        fail(statement.line, "not a finite number: " + in_quotes(word));
    return value;
}

long CageLines::whole(const Statement& statement, std::string_view word) const {
    long value = 0;
    if (!read_whole_word(word, value))
        fail(statement.line, "not a whole number: " + in_quotes(word));
    return value;
}

namespace {

/// Tags that say how textures, not the surface, are interpolated.
constexpr std::array texture_tags{"facevaryinginterpolateboundary", "facevaryingpropagatecorners"};

std::array<std::size_t, 3> value_counts(const Statement& s, const CageLines& lines) {
    std::array<std::size_t, 3> counts{};
    std::string_view word = s.words[2];
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t slash = word.find('/');
        if ((slash == std::string_view::npos) != (k == 2))
            lines.fail(s.line, "a tag needs its counts as INTEGERS/FLOATS/STRINGS");
        const long count = lines.whole(s, word.substr(0, slash));
        if (count < 0 || static_cast<std::size_t>(count) > s.words.size())
            lines.fail(s.line, "the tag has fewer values than it says");
        counts[k] = static_cast<std::size_t>(count);
        if (k < 2) word.remove_prefix(slash + 1);
    }
    return counts;
}

class TagWriter {
public:
    TagWriter(const CageLines& lines, Cage& cage) : lines_(lines), cage_(cage) {}

    void write(const CageTag& tag) {
        if (tag.name == "crease") return crease(tag);
        if (tag.name == "corner") return corner(tag);
        if (tag.name == "hole") return hole(tag);
        if (tag.name == "interpolateboundary") return boundary(tag);
        if (tag.name == "creasemethod")
            cage_.crease_method = choice(tag, {"normal", "chaikin"}) == 0 ? CreaseMethod::uniform
                                                                          : CreaseMethod::chaikin;
        else if (tag.name == "smoothtriangles")
            cage_.triangles = choice(tag, {"catmark", "smooth"}) == 0 ? TriangleRule::catmull_clark
                                                                      : TriangleRule::smooth;
        else if (tag.name == "scheme")
            scheme(tag);
        else if (std::find(texture_tags.begin(), texture_tags.end(), tag.name) ==
                 texture_tags.end())
            lines_.fail(tag.line, "unknown tag " + in_quotes(tag.name));
    }

    /// Without a tag, triangles alone make a Loop cage.
    void choose_scheme() {
        const bool triangles =
            std::all_of(cage_.faces.begin(), cage_.faces.end(),
                        [](const CageFace& face) { return face.corner_count == 3; });
        if (scheme_told_) return;
        if (triangles) cage_.scheme = Scheme::loop;
        if (triangles)
            cage_.diagnostics.push_back({Severity::note, "",
                                         "all faces are triangles: read as a Loop cage (t scheme "
                                         "0/0/1 catmark overrides)"});
    }

private:
    std::uint32_t vertex(const CageTag& tag, long number) const {
        if (number < 0 || static_cast<std::size_t>(number) >= cage_.vertices.size())
            lines_.fail(tag.line,
                        "there is no vertex " + std::to_string(number) + " (tags count from 0)");
        return static_cast<std::uint32_t>(number);
    }

    double sharpness(const CageTag& tag, std::size_t k) const {
        const double value = tag.floats[tag.floats.size() == 1 ? 0 : k];
        if (!(value >= 0)) lines_.fail(tag.line, "a sharpness must not be below 0");
        return std::min(value, infinite_sharpness);
    }

    void require_sharpness(const CageTag& tag, std::size_t count) const {
        if (tag.floats.size() != 1 && tag.floats.size() != count)
            lines_.fail(tag.line, "the tag needs one sharpness or " + std::to_string(count));
    }

    void crease(const CageTag& tag) {
        if (tag.integers.size() < 2) lines_.fail(tag.line, "a crease needs two vertices");
        require_sharpness(tag, tag.integers.size() - 1);
        for (std::size_t k = 0; k + 1 < tag.integers.size(); ++k) {
            const std::uint32_t a = vertex(tag, tag.integers[k]);
            const std::uint32_t b = vertex(tag, tag.integers[k + 1]);
            cage_.creases.push_back({a, b, sharpness(tag, k), tag.line});
        }
    }

    void corner(const CageTag& tag) {
        require_sharpness(tag, tag.integers.size());
        for (std::size_t k = 0; k < tag.integers.size(); ++k)
            cage_.sharp_corners.push_back({vertex(tag, tag.integers[k]), sharpness(tag, k)});
    }

    void hole(const CageTag& tag) {
        for (const long face : tag.integers) {
            if (face < 0 || static_cast<std::size_t>(face) >= cage_.faces.size())
                lines_.fail(tag.line,
                            "there is no face " + std::to_string(face) + " (tags count from 0)");
            cage_.faces[static_cast<std::size_t>(face)].hole = true;
        }
    }

    void boundary(const CageTag& tag) {
        if (tag.integers.size() != 1 || tag.integers[0] < 0 || tag.integers[0] > 2)
            lines_.fail(tag.line, "interpolateboundary is 0, 1 or 2");
        constexpr std::array rules{BoundaryRule::none, BoundaryRule::edge_and_corner,
                                   BoundaryRule::edge_only};
        cage_.boundary = rules[static_cast<std::size_t>(tag.integers[0])];
    }

    void scheme(const CageTag& tag) {
        cage_.scheme = choice(tag, {"catmark", "loop"}) == 0 ? Scheme::catmull_clark : Scheme::loop;
        scheme_told_ = true;
        for (const CageFace& face : cage_.faces)
            if (cage_.scheme == Scheme::loop && face.corner_count != 3)
                lines_.fail(face.line, "a Loop cage may have triangles only");
    }

    /// Which of the words the tag says.
    std::size_t choice(const CageTag& tag, std::array<const char*, 2> words) const {
        for (std::size_t k = 0; k < words.size(); ++k)
            if (tag.strings.size() == 1 && tag.strings[0] == words[k]) return k;
        lines_.fail(tag.line, tag.name + " is " + words[0] + " or " + words[1]);
    }

    const CageLines& lines_;
    Cage& cage_;
    bool scheme_told_ = false;
};

} // namespace

CageTag read_tag(const Statement& s, const CageLines& lines) {
    if (s.words.size() < 3) lines.fail(s.line, "a tag needs a name and INTEGERS/FLOATS/STRINGS");
    const auto counts = value_counts(s, lines);
    if (s.words.size() != 3 + counts[0] + counts[1] + counts[2])
        lines.fail(s.line, "the tag has other values than it says");
    CageTag tag{std::string(s.words[1]), {}, {}, {}, s.line};
    auto word = s.words.begin() + 3;
    for (std::size_t i = 0; i < counts[0]; ++i) tag.integers.push_back(lines.whole(s, *word++));
    for (std::size_t i = 0; i < counts[1]; ++i) tag.floats.push_back(lines.number(s, *word++));
    for (std::size_t i = 0; i < counts[2]; ++i) tag.strings.emplace_back(*word++);
    return tag;
}

void apply(const std::vector<CageTag>& tags, const CageLines& lines, Cage& cage) {
    TagWriter writer(lines, cage);
    for (const CageTag& tag : tags) writer.write(tag);
    writer.choose_scheme();
}

} // namespace keiko::subdivision
