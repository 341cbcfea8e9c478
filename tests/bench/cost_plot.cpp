#include "tests/bench/cost_plot.h"

#include "tests/bench/table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace keiko::bench {
namespace {

constexpr double panel_width = 420, height = 340, left = 70, top = 40, right = 20, bottom = 50;
constexpr const char* colours[] = {"#c03", "#06c", "#393", "#960"};

/// A logarithmic axis from pixel to pixel.
struct LogAxis {
    double low, high, begin, end;

    double at(double value) const {
        return begin + (end - begin) * std::log(value / low) / std::log(high / low);
    }
};

class Plot {
public:
    Plot(std::ostream& out, LogAxis x, LogAxis y) : out_(out), x_(x), y_(y) {}

    void frame(const CostPanel& panel, const std::string& up) {
        for (double v = y_.low; v <= y_.high * 1.001; v *= 10) {
            line(x_.begin, y_.at(v), x_.end, y_.at(v), "#ddd");
            text(x_.begin - 6, y_.at(v) + 4, "end", digits(v));
        }
        for (const auto& [x, y] : panel.lines.front().points) {
            line(x_.at(x), y_.begin, x_.at(x), y_.end, "#eee");
            text(x_.at(x), y_.begin + 18, "middle", digits(x));
        }
        text((x_.begin + x_.end) / 2, height - 12, "middle", panel.across);
        text((x_.begin + x_.end) / 2, top - 16, "middle", panel.title);
        text(x_.begin - 50, top - 16, "start", up);
    }
    void curve(const CostLine& curve, const char* colour) {
        std::ostringstream path;
        for (const auto& [x, y] : curve.points) {
            path << (path.tellp() == 0 ? "M" : "L") << x_.at(x) << " " << y_.at(y);
            out_ << "<circle cx=\"" << x_.at(x) << "\" cy=\"" << y_.at(y) << "\" r=\"3\" fill=\""
                 << colour << "\"/>\n";
        }
        out_ << "<path d=\"" << path.str() << "\" fill=\"none\" stroke=\"" << colour
             << "\" stroke-width=\"2\"/>\n";
        const auto& [x, y] = curve.points.front();
        text(x_.at(x) + 6, y_.at(y) - 10, "start", curve.name, colour);
    }

private:
    void line(double x0, double y0, double x1, double y1, const char* colour) {
        out_ << "<path d=\"M" << x0 << " " << y0 << "L" << x1 << " " << y1 << "\" stroke=\""
             << colour << "\"/>\n";
    }
    void text(double x, double y, const char* anchor, const std::string& words,
              const char* colour = "#333") {
        out_ << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\" fill=\""
             << colour << "\">" << words << "</text>\n";
    }

    std::ostream& out_;
    LogAxis x_, y_;
};

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = 0;

    void extend(double value) { low = std::min(low, value), high = std::max(high, value); }
};

} // namespace

std::string cost_plot_svg(const std::vector<CostPanel>& panels, const std::string& up) {
    Range cost;
    for (const CostPanel& panel : panels)
        for (const CostLine& line : panel.lines)
            for (const auto& point : line.points) cost.extend(point.second);
    const LogAxis y{std::pow(10, std::floor(std::log10(cost.low))),
                    std::pow(10, std::ceil(std::log10(cost.high))), height - bottom, top};
    std::ostringstream out;
    out.precision(5);
    const double width = panel_width * static_cast<double>(panels.size());
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << " " << height
        << "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"" << width
        << "\" height=\"" << height << "\" fill=\"#fff\"/>\n";
    double begin = 0;
    for (const CostPanel& panel : panels) {
        Range sizes;
        for (const CostLine& line : panel.lines)
            for (const auto& point : line.points) sizes.extend(point.first);
        Plot plot(out, {sizes.low, sizes.high, begin + left, begin + panel_width - right}, y);
        plot.frame(panel, up);
        for (std::size_t i = 0; i < panel.lines.size(); ++i)
            plot.curve(panel.lines[i], colours[i % std::size(colours)]);
        begin += panel_width;
    }
    out << "</svg>\n";
    return out.str();
}

} // namespace keiko::bench
