#include "keiko/base/error.h"
#include "keiko/files/scan/scan_formats.h"
#include "keiko/files/scan/text_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <unordered_set>

namespace keiko {
namespace {

constexpr std::size_t header_size = 84, triangle_size = 50, normal_size = 12;

/// Collects the corners of triangles, each place once: neighbours repeat them.
class DistinctPoints {
public:
    /// Places that are no numbers stay apart: they equal nothing, and are refused by whoever reads.
    void add(const Vec3& point) {
        if (!is_finite(point) ||
            seen_.insert(Place{point.x + 0.0, point.y + 0.0, point.z + 0.0}).second)
            points_.push_back(point);
    }
    std::vector<Vec3> take() { return std::move(points_); }

private:
    using Place = std::array<double, 3>; ///< without the sign of a zero
    struct Hash {
        std::size_t operator()(const Place& place) const {
            std::uint64_t hash = 0;
            for (const double x : place) {
                hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15;
                hash ^= hash >> 29;
            }
            return hash;
        }
    };

    std::unordered_set<Place, Hash> seen_;
    std::vector<Vec3> points_;
};

std::uint32_t triangle_count(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + header_size - sizeof count, sizeof count);
    return count;
}

/// Whether the bytes are as many as the count of a binary file claims. ASCII files hold no such
/// number there.
bool is_binary(std::string_view bytes) {
    return bytes.size() >= header_size &&
           bytes.size() == header_size + std::size_t{triangle_count(bytes)} * triangle_size;
}

std::vector<Vec3> binary_points(std::string_view bytes) {
    DistinctPoints points;
    for (std::size_t at = header_size; at < bytes.size(); at += triangle_size) {
        std::array<float, 9> corners{};
        std::memcpy(corners.data(), bytes.data() + at + normal_size, sizeof corners);
        for (std::size_t k = 0; k < 9; k += 3)
            points.add(Vec3(corners[k], corners[k + 1], corners[k + 2]));
    }
    return points.take();
}

Vec3 vertex(std::string_view words, const std::string& file, std::size_t line) {
    Vec3 point(0);
    for (unsigned k = 0; k < 3; ++k) {
        const std::string_view word = take_word(words);
        const auto number = number_in(word);
        if (!number)
            throw Error(
                file, std::to_string(line),
                word.empty() ? "a vertex has three numbers" : "not a number: " + in_quotes(word));
        point[k] = *number;
    }
    return point;
}

std::vector<Vec3> ascii_points(std::string_view bytes, const std::string& file) {
    DistinctPoints points;
    LineReader lines(bytes);
    bool ended = false;
    while (const auto line = lines.next()) {
        std::string_view words = *line;
        const std::string word = lower_case(std::string(take_word(words)));
        if (word == "vertex") points.add(vertex(words, file, lines.number()));
        if (!word.empty()) ended = word == "endsolid";
    }
    if (!ended) throw Error(file, "", "is cut short: its end, \"endsolid\", is missing");
    return points.take();
}

/// Whether the text of an ASCII file begins here: binary files may begin with "solid" as well.
bool is_ascii(std::string_view bytes) {
    return bytes.starts_with("solid") && bytes.find('\0') == std::string_view::npos;
}

} // namespace

std::vector<Vec3> stl_points(std::string_view bytes, const std::string& file) {
    if (is_binary(bytes)) return binary_points(bytes);
    if (is_ascii(bytes)) return ascii_points(bytes, file);
    if (bytes.size() < header_size)
        throw Error(file, "", "is no STL file: it neither begins with \"solid\" nor has 84 bytes");
    throw Error(
        file, "",
        "is no STL file, or cut short: " + counted(triangle_count(bytes), "triangle") + " need " +
            std::to_string(header_size + std::size_t{triangle_count(bytes)} * triangle_size) +
            " bytes, and it has " + std::to_string(bytes.size()));
}

} // namespace keiko
