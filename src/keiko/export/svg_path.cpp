#include "keiko/export/svg_path.h"

#include <cmath>
#include <cstddef>
#include <sstream>

namespace keiko {
namespace {

/// Writes coordinates relative to each other, in as few letters as SVG allows.
class PathWriter {
public:
    PathWriter(double height, int decimals) : height_(height), unit_(decimals == 1 ? 10 : 100) {}

    void add(const std::vector<Vec2>& line) {
        long long x = rounded(line[0].x), y = rounded(height_ - line[0].y);
        text_ << 'M' << number(x) << ' ' << number(y) << 'l';
        bool first = true;
        for (std::size_t i = 1; i < line.size(); ++i) {
            const long long next_x = rounded(line[i].x), next_y = rounded(height_ - line[i].y);
            if (next_x == x && next_y == y && (i + 1 < line.size() || !first)) continue;
            if (!first) text_ << ' ';
            text_ << number(next_x - x) << ' ' << number(next_y - y);
            x = next_x, y = next_y, first = false;
        }
    }
    std::string text() const { return text_.str(); }

private:
    long long rounded(double value) const {
        return std::llround(value * static_cast<double>(unit_));
    }

    std::string number(long long value) const {
        const long long size = std::abs(value), whole = size / unit_;
        long long rest = size % unit_;
        std::string text = value < 0 ? "-" : "";
        if (whole > 0 || rest == 0) text += std::to_string(whole);
        if (rest == 0) return text;
        text += '.';
        for (long long place = unit_ / 10; rest > 0; rest %= place, place /= 10)
            text += static_cast<char>('0' + rest / place);
        return text;
    }

    double height_;
    long long unit_; ///< of a coordinate
    std::ostringstream text_;
};

} // namespace

std::string svg_path(const std::vector<std::vector<Vec2>>& lines, double height, int decimals) {
    PathWriter path(height, decimals);
    for (const std::vector<Vec2>& line : lines) path.add(line);
    return path.text();
}

} // namespace keiko
