#include "keiko/files/model/bezier_file.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/job.h"
#include "keiko/base/text.h"
#include "keiko/files/model/model_format.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace keiko {
namespace {

/// mm; products of a few coordinates up to here stay finite.
constexpr double largest_coordinate = 1e15;
/// Weights from its inverse to here keep the digits of the points they are multiplied with.
constexpr double largest_weight = 1e15;

/// The lines of a file that hold numbers.
class NumberLines {
public:
    explicit NumberLines(const std::filesystem::path& path)
        : file_(path.string()), text_(read_text_file(path)) {}

    /// Numbers of the next line that has any; an error at the end of the file.
    std::vector<double> next(const char* wanted) {
        while (position_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', position_), text_.size());
            const std::string_view line =
                std::string_view(text_).substr(position_, end - position_);
            position_ = end + 1;
            ++line_;
            if (auto numbers = parse(line.substr(0, line.find('#'))); !numbers.empty())
                return numbers;
        }
        ++line_;
        fail(std::string("the file ends where ") + wanted + " should follow");
    }

    /// Exactly `count` numbers, each whole and from `least` to `most`.
    std::vector<std::size_t> next_whole(std::size_t count, double least, double most,
                                        const char* wanted) {
        const std::vector<double> numbers = next(wanted);
        if (numbers.size() != count) fail(std::string("expected ") + wanted);
        std::vector<std::size_t> whole;
        for (const double n : numbers) {
            if (!(n >= least && n <= most) || n != std::floor(n))
                fail(std::string("out of range: ") + wanted);
            whole.push_back(static_cast<std::size_t>(n));
        }
        return whole;
    }

    /// No count can be larger than what is left of the file.
    double most_lines() const {
        return static_cast<double>(text_.size() - std::min(position_, text_.size())) / 2 + 1;
    }

    void expect_end() {
        while (position_ < text_.size()) {
            ++line_;
            const std::size_t end = std::min(text_.find('\n', position_), text_.size());
            std::string_view line = std::string_view(text_).substr(position_, end - position_);
            line = line.substr(0, line.find('#'));
            if (line.find_first_not_of(" \t\r,") != std::string_view::npos)
                fail("more lines than the counts say");
            position_ = end + 1;
        }
    }

    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(file_, std::to_string(line_), reason);
    }

private:
    std::vector<double> parse(std::string_view line) const {
        constexpr std::string_view blanks = " \t\r,";
        std::vector<double> numbers;
        while (true) {
            const std::size_t begin = line.find_first_not_of(blanks);
            if (begin == std::string_view::npos) return numbers;
            line.remove_prefix(begin);
            const std::string_view word = line.substr(0, line.find_first_of(blanks));
            numbers.push_back(number(word));
            line.remove_prefix(word.size());
        }
    }

    double number(std::string_view word) const {
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        double value = 0;
        const auto [end, code] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (code != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
            fail("not a finite number: " + in_quotes(word));
        return value;
    }

    std::string file_, text_;
    std::size_t position_ = 0;
    int line_ = 0;
};

/// Whether a patch has no area since its points lie on one line or in one place, within their
/// rounding.
bool has_no_extent(const std::vector<Vec4>& points) {
    const Vec3 first = euclidean(points.front());
    Vec3 along(0);
    double farthest = 0;
    for (const Vec4& p : points) {
        farthest = std::max(farthest, euclidean(p).length());
        if (const Vec3 way = euclidean(p) - first; way.length() > along.length()) along = way;
    }
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * farthest;
    return std::all_of(points.begin(), points.end(), [&](const Vec4& p) {
        return (euclidean(p) - first).cross(along).length() <= rounding * along.length();
    });
}

/// The border of the unit square, counter-clockwise, as trim loop of the newest face.
void append_border(SurfaceModel& model) {
    constexpr double corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    model.trim_loops.push_back({static_cast<std::uint32_t>(model.trim_curves.size()), 4});
    for (int i = 0; i < 4; ++i) {
        model.trim_curves.push_back(
            {static_cast<std::uint32_t>(model.trim_points.size()), 1, no_index});
        for (const auto& corner : {corners[i], corners[i + 1]})
            model.trim_points.emplace_back(corner[0], corner[1], 1);
    }
}

void append_face(SurfaceModel& model, std::size_t degree_u, std::size_t degree_v,
                 const std::vector<Vec4>& points) {
    const auto index = static_cast<std::uint32_t>(model.faces.size());
    Face face;
    face.id = index + static_cast<std::uint32_t>(model.lost_faces.size()) + 1;
    face.surface_kind = "bezier";
    face.first_patch = index;
    face.patch_count = 1;
    face.first_loop = index;
    face.loop_count = 1;
    model.faces.push_back(face);
    Patch patch;
    patch.face = index;
    patch.first_point = static_cast<std::uint32_t>(model.control_points.size());
    patch.degree_u = static_cast<std::uint16_t>(degree_u);
    patch.degree_v = static_cast<std::uint16_t>(degree_v);
    model.patches.push_back(patch);
    model.control_points.insert(model.control_points.end(), points.begin(), points.end());
    append_border(model);
}

SurfaceModel finished(SurfaceModel model, const std::filesystem::path& path, ModelFormat format) {
    model.source = path.string();
    model.format = std::string(name_of(format));
    model.parts.push_back(
        {path.stem().string(), 0, static_cast<std::uint32_t>(model.faces.size())});
    model.instances.push_back({0, path.stem().string(), {}});
    return model;
}

std::vector<Vec4> read_points(NumberLines& lines, std::size_t count) {
    std::vector<Vec4> points;
    std::size_t columns = 0;
    while (points.size() < count) {
        check_stop();
        const std::vector<double> n = lines.next("a control point");
        if (columns == 0) columns = n.size();
        if (n.size() != columns || (columns != 3 && columns != 4))
            lines.fail("expected a control point \"x y z\" or \"x y z w\", alike in a patch");
        const double w = columns == 4 ? n[3] : 1;
        if (!(w > 0)) lines.fail("a weight must be above 0");
        if (!(w <= largest_weight && w >= 1 / largest_weight))
            lines.fail("a weight must be from 1e-15 to 1e15");
        for (const double x : {n[0], n[1], n[2]})
            if (!(std::abs(x) <= largest_coordinate))
                lines.fail("a coordinate must be from -1e15 to 1e15");
        points.emplace_back(n[0] * w, n[1] * w, n[2] * w, w);
    }
    return points;
}

} // namespace

SurfaceModel read_bezier_file(const std::filesystem::path& path) {
    NumberLines lines(path);
    SurfaceModel model;
    const std::size_t count =
        lines.next_whole(1, 1, lines.most_lines(), "the number of patches").front();
    for (std::size_t i = 0; i < count; ++i) {
        const auto degrees = lines.next_whole(2, 1, max_degree, "two degrees from 1 to 25");
        const auto points = read_points(lines, (degrees[0] + 1) * (degrees[1] + 1));
        if (has_no_extent(points))
            model.lost_faces.push_back(
                {static_cast<std::uint32_t>(i + 1), "",
                 "its points lie on one line or in one place: it has no area"});
        else
            append_face(model, degrees[0], degrees[1], points);
    }
    lines.expect_end();
    if (model.faces.empty())
        throw Error(path.string(), "",
                    "the points of each patch lie on one line or in one place: it is no surface");
    return finished(std::move(model), path, ModelFormat::bezier);
}

SurfaceModel read_teapot_file(const std::filesystem::path& path) {
    NumberLines lines(path);
    const std::size_t patch_count =
        lines.next_whole(1, 1, lines.most_lines(), "the number of patches").front();
    std::vector<std::vector<std::size_t>> patches;
    for (std::size_t i = 0; i < patch_count; ++i)
        patches.push_back(lines.next_whole(16, 1, lines.most_lines(), "16 vertex numbers"));
    const std::size_t vertex_count =
        lines.next_whole(1, 1, lines.most_lines(), "the number of vertices").front();
    std::vector<Vec4> vertices;
    for (std::size_t i = 0; i < vertex_count; ++i)
        vertices.push_back(read_points(lines, 1).front());
    lines.expect_end();

    SurfaceModel model;
    for (std::size_t i = 0; i < patch_count; ++i) {
        std::vector<Vec4> points;
        for (const std::size_t vertex : patches[i]) {
            if (vertex > vertices.size())
                throw Error(path.string(), "patch " + std::to_string(i + 1),
                            "there is no vertex " + std::to_string(vertex));
            points.push_back(vertices[vertex - 1]);
        }
        append_face(model, 3, 3, points);
    }
    return finished(std::move(model), path, ModelFormat::teapot);
}

} // namespace keiko
