#include "keiko/base/error.h"
#include "keiko/files/scan/scan_formats.h"
#include "keiko/files/scan/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>

namespace keiko {
namespace {

enum class Encoding { ascii, little_endian, big_endian };
enum class Number { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// A property of an element; `length` is there if it is a list.
struct Property {
    std::string name;
    Number type = Number::float32;
    std::optional<Number> length{};
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties{};
};

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements{};
    std::string_view body{};
    std::size_t lines = 0; ///< of the header
};

std::optional<Number> number_type(std::string_view word) {
    constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                    {"uchar", "uint8"},
                                                                    {"short", "int16"},
                                                                    {"ushort", "uint16"},
                                                                    {"int", "int32"},
                                                                    {"uint", "uint32"},
                                                                    {"float", "float32"},
                                                                    {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i][0] || word == names[i][1]) return static_cast<Number>(i);
    return std::nullopt;
}

constexpr std::size_t size_of(Number type) {
    return std::array<std::size_t, 8>{1, 1, 2, 2, 4, 4, 4, 8}[static_cast<std::size_t>(type)];
}

/// Reads the header, line by line.
class HeaderReader {
public:
    HeaderReader(std::string_view bytes, const std::string& file) : lines_(bytes), file_(file) {}

    Header read() {
        if (lines_.next() != "ply") throw Error(file_, "1", "is no PLY file: \"ply\" is missing");
        bool has_format = false;
        while (const auto line = lines_.next()) {
            std::string_view words = *line;
            const std::string_view keyword = take_word(words);
            if (keyword == "end_header") {
                if (!has_format) fail("the format is missing");
                header_.body = lines_.rest(), header_.lines = lines_.number();
                return header_;
            }
            if (keyword == "format")
                has_format = true, header_.encoding = encoding(words);
            else if (keyword == "element")
                header_.elements.push_back(element(words));
            else if (keyword == "property")
                add_property(words);
            else if (keyword != "comment" && keyword != "obj_info")
                fail("unknown keyword " + in_quotes(keyword));
        }
        fail("is cut short: \"end_header\" is missing");
    }

private:
    Encoding encoding(std::string_view words) const {
        const std::string_view name = take_word(words);
        if (name == "ascii") return Encoding::ascii;
        if (name == "binary_little_endian") return Encoding::little_endian;
        if (name == "binary_big_endian") return Encoding::big_endian;
        fail("unknown format " + in_quotes(name));
    }
    Element element(std::string_view words) const {
        Element element{.name = std::string(take_word(words))};
        const std::string_view count = take_word(words);
        const auto [end, code] =
            std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (code != std::errc() || end != count.data() + count.size())
            fail("not a count: " + in_quotes(count));
        return element;
    }
    void add_property(std::string_view words) {
        if (header_.elements.empty()) fail("a property without an element");
        Property property;
        std::string_view word = take_word(words);
        if (word == "list") {
            property.length = type(take_word(words));
            if (*property.length >= Number::float32)
                fail("the length of a list is no whole number");
            word = take_word(words);
        }
        property.type = type(word), property.name = take_word(words);
        header_.elements.back().properties.push_back(std::move(property));
    }
    Number type(std::string_view word) const {
        if (const auto found = number_type(word)) return *found;
        fail("unknown type " + in_quotes(word));
    }
    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(file_, std::to_string(lines_.number()), reason);
    }

    LineReader lines_;
    const std::string& file_;
    Header header_;
};

template <class T>
double value_of(const std::array<char, 8>& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
}

/// Numbers of the body, one after the other.
class BodyReader {
public:
    BodyReader(const Header& header, const std::string& file)
        : encoding_(header.encoding), rest_(header.body), file_(file) {}

    double take(Number type) { return encoding_ == Encoding::ascii ? word() : binary(type); }

    /// Passes over an element's rows until the last of them.
    void skip(const Element& element) {
        if (element.properties.empty()) return;
        for (std::size_t i = 0; i < element.count; ++i)
            for (const Property& property : element.properties) skip(property);
    }
    void skip(const Property& property) {
        const double count = property.length ? take(*property.length) : 1;
        for (double i = 0; i < count; ++i) take(property.type);
    }
    /// Throws if the rows of an element cannot all be there: found before anything is allocated.
    void require(const Element& element) const {
        std::size_t least = 0; // bytes of a row
        for (const Property& property : element.properties)
            least +=
                encoding_ == Encoding::ascii ? 2 : size_of(property.length.value_or(property.type));
        if (least > 0 && element.count > (rest_.size() + 1) / least) end_early();
    }

private:
    double word() {
        const std::string_view word = take_word(rest_, " \t\r\n");
        if (word.empty()) end_early();
        const auto number = number_in(word);
        if (!number) throw Error(file_, "", "not a number: " + in_quotes(word));
        return *number;
    }
    double binary(Number type) {
        const std::size_t size = size_of(type);
        if (rest_.size() < size) end_early();
        std::array<char, 8> bytes{};
        std::memcpy(bytes.data(), rest_.data(), size);
        rest_.remove_prefix(size);
        if (encoding_ == Encoding::big_endian)
            std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        switch (type) {
            case Number::int8:
                return value_of<std::int8_t>(bytes);
            case Number::uint8:
                return value_of<std::uint8_t>(bytes);
            case Number::int16:
                return value_of<std::int16_t>(bytes);
            case Number::uint16:
                return value_of<std::uint16_t>(bytes);
            case Number::int32:
                return value_of<std::int32_t>(bytes);
            case Number::uint32:
                return value_of<std::uint32_t>(bytes);
            case Number::float32:
                return value_of<float>(bytes);
            case Number::float64:
                return value_of<double>(bytes);
        }
        return 0;
    }
    [[noreturn]] void end_early() const {
        throw Error(file_, "", "is cut short: it ends before its last vertex");
    }

    Encoding encoding_;
    std::string_view rest_;
    const std::string& file_;
};

std::optional<unsigned> axis_of(const Property& property) {
    if (property.length || property.name.size() != 1) return std::nullopt;
    const char name = property.name.front();
    return name >= 'x' && name <= 'z' ? std::optional(static_cast<unsigned>(name - 'x'))
                                      : std::nullopt;
}

void require_coordinates(const Element& vertices, const std::string& file) {
    std::array<int, 3> found{};
    for (const Property& property : vertices.properties)
        if (const auto axis = axis_of(property)) ++found[*axis];
    if (found != std::array{1, 1, 1})
        throw Error(file, "element vertex", "one property each of x, y and z is needed");
}

std::vector<Vec3> vertices_of(const Element& vertices, BodyReader& body) {
    std::vector<Vec3> points(vertices.count, Vec3(0));
    for (Vec3& point : points)
        for (const Property& property : vertices.properties)
            if (const auto axis = axis_of(property))
                point[*axis] = body.take(property.type);
            else
                body.skip(property);
    return points;
}

} // namespace

std::vector<Vec3> ply_points(std::string_view bytes, const std::string& file) {
    const Header header = HeaderReader(bytes, file).read();
    BodyReader body(header, file);
    for (const Element& element : header.elements) {
        body.require(element);
        if (element.name == "vertex") {
            require_coordinates(element, file);
            return vertices_of(element, body);
        }
        body.skip(element);
    }
    throw Error(file, "", "has no element \"vertex\"");
}

} // namespace keiko
