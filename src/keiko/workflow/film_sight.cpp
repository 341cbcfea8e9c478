#include "keiko/workflow/film_sight.h"

#include "keiko/film/overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace keiko {
namespace {

/// Lines of words, none wider than `width` if words can be broken there.
std::vector<std::string> wrapped(const std::string& words, double width) {
    std::vector<std::string> lines{""};
    std::istringstream in(words);
    for (std::string word; in >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || text_size(longer, 1).x <= width)
            lines.back() = longer;
        else
            lines.push_back(word);
    }
    return lines;
}

} // namespace

std::optional<Seen> FilmSight::at(int x, int y) const {
    const float* n = layer(Aov::normal, x, y);
    const double depth{*layer(Aov::depth, x, y)};
    const Vec3 normal(double{n[0]}, double{n[1]}, double{n[2]});
    if (!std::isfinite(depth) || !(normal.length() > 0)) return std::nullopt;
    const Ray ray = camera_.ray(x + 0.5, y + 0.5);
    const bool turned = normal.dot(ray.direction) > 0;
    return Seen{ray.origin + ray.direction * depth, ray.direction,
                turned ? -normal.normalized() : normal.normalized(), turned};
}

bool PixelValues::is_continued(int x, int y, int other_x, int other_y) const {
    return other_x >= 0 && other_y >= 0 && other_x < sight_.width() && other_y < sight_.height() &&
           *sight_.layer(within_, x, y) == *sight_.layer(within_, other_x, other_y) &&
           !std::isnan(at(other_x, other_y));
}

double PixelValues::slope(int x, int y, int dx, int dy) const {
    double least = std::numeric_limits<double>::infinity();
    for (const int side : {-1, 1})
        if (is_continued(x, y, x + side * dx, y + side * dy))
            least = std::min(least, std::abs(at(x + side * dx, y + side * dy) - at(x, y)));
    return std::isfinite(least) ? least : 0;
}

Image with_caption(Image picture, const std::string& words) {
    constexpr double margin = 8, line_height = 11;
    const std::vector<std::string> lines = wrapped(words, picture.width - 2 * margin);
    double y = picture.height - 3 - line_height * static_cast<double>(lines.size());
    Overlay overlay;
    for (const std::string& line : lines) {
        overlay.texts.push_back(
            {.at = Vec2(margin, y), .text = line, .color = Rgb(0.85), .scale = 1});
        y += line_height;
    }
    return with_overlay(std::move(picture), overlay);
}

} // namespace keiko
