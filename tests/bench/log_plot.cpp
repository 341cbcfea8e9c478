#include "tests/bench/log_plot.h"

#include "keiko/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace keiko::bench {
namespace {

constexpr double width = 434, height = 350, left = 62, right = 28, bottom = 50; // px
constexpr double name_height = 15;
constexpr std::array colours{"#1f5fa8", "#c2571a", "#3a7d44", "#7a3e8e", "#8a6d00", "#333333"};

/// The powers of ten around what is shown along one axis.
struct Axis {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void extend(double value) {
        low = std::min(low, std::floor(std::log10(value)));
        high = std::max(high, std::ceil(std::log10(value)));
    }
    double share(double value) const {
        return (std::log10(value) - low) / std::max(high - low, 1.0);
    }
};

std::string text(double x, double y, const std::string& anchor, const std::string& words,
                 const std::string& more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                       anchor, more, words);
}

std::string line(double x0, double y0, double x1, double y1, const char* colour) {
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x0, y0,
        x1, y1, colour);
}

class Panel {
public:
    explicit Panel(const LogPlot& plot)
        : plot_(plot), top_(10 + name_height * static_cast<double>(plot.curves.size())) {
        for (const LogPlot::Curve& curve : plot.curves)
            for (const auto& [x, y] : curve.points) x_.extend(x), y_.extend(y);
    }
    std::string svg() const {
        std::string all = axes();
        for (std::size_t i = 0; i < plot_.curves.size(); ++i) all += curve(i);
        return all;
    }

private:
    double px(double x) const { return left + (width - left - right) * x_.share(x); }
    double py(double y) const { return height - bottom - (height - top_ - bottom) * y_.share(y); }

    std::string axes() const {
        std::string all;
        for (double e = x_.low; e <= x_.high; ++e) {
            const double x = px(std::pow(10, e));
            all += line(x, top_, x, height - bottom, "#ddd");
            all += text(x, height - bottom + 16, "middle", fmt::format("{:g}", std::pow(10, e)));
        }
        for (double e = y_.low; e <= y_.high; ++e) {
            const double y = py(std::pow(10, e));
            all += line(left, y, width - right, y, "#ddd");
            all += text(left - 6, y + 4, "end", fmt::format("{:g}", std::pow(10, e)));
        }
        all += text((left + width - right) / 2, height - 10, "middle", plot_.x);
        const double middle = (top_ + height - bottom) / 2;
        return all + text(14, middle, "middle", plot_.y,
                          fmt::format(" transform=\"rotate(-90 14 {:.1f})\"", middle));
    }
    std::string curve(std::size_t i) const {
        const LogPlot::Curve& c = plot_.curves[i];
        const char* colour = colours[c.colour.value_or(i) % colours.size()];
        std::string places, dots;
        for (const auto& [x, y] : c.points) {
            places += fmt::format("{:.1f},{:.1f} ", px(x), py(y));
            dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n",
                                px(x), py(y), colour);
        }
        // Names stand above the plot, where no line runs.
        const double name = name_height * (1 + static_cast<double>(i));
        return fmt::format(
                   "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" "
                   "stroke-width=\"1.6\"/>\n",
                   places, colour) +
               dots + line(left, name - 4, left + 22, name - 4, colour) +
               text(left + 28, name, "start", c.name, fmt::format(" fill=\"{}\"", colour));
    }

    const LogPlot& plot_;
    double top_; ///< px, below the names of the curves
    Axis x_, y_;
};

} // namespace

void write_svg(const std::filesystem::path& file, const std::vector<LogPlot>& panels) {
    const double whole = width * static_cast<double>(panels.size());
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        whole, height);
    for (std::size_t i = 0; i < panels.size(); ++i)
        svg += fmt::format("<g transform=\"translate({} 0)\">\n{}</g>\n",
                           width * static_cast<double>(i), Panel(panels[i]).svg());
    std::ofstream out(file);
    if (!(out << svg << "</svg>\n")) throw Error(file.string(), "", "cannot be written");
}

} // namespace keiko::bench
