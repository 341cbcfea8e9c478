#include "keiko/base/units.h"
#include "keiko/report/content/luminaire_facts.h"
#include "keiko/report/markup/html_text.h"

#include <cmath>
#include <sstream>

namespace keiko {
namespace {

constexpr double size = 640, middle_x = 320, middle_y = 340, radius = 260;
constexpr int rings = 4;

/// The smallest of 1, 2, 4, 5, 8 times a power of ten that is not below `value`.
double round_scale(double value) {
    if (!(value > 0)) return 1;
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 4.0, 5.0, 8.0})
        if (digit * power >= value) return digit * power;
    return 10 * power;
}

class PolarPlot {
public:
    PolarPlot(std::ostream& out, const LuminaireFacts& facts)
        : out_(out), facts_(facts), scale_(round_scale(facts.largest_intensity)) {}

    void grid() {
        for (int i = 1; i <= rings; ++i) {
            const double r = radius * i / rings;
            out_ << "<circle cx=\"" << middle_x << "\" cy=\"" << middle_y << "\" r=\"" << r
                 << "\"/>\n";
        }
        for (int degrees = 0; degrees < 180; degrees += 30) {
            const double angle = degrees_to_radians(degrees);
            const double x = radius * std::sin(angle), y = radius * std::cos(angle);
            out_ << "<path d=\"M" << middle_x - x << " " << middle_y - y << "L" << middle_x + x
                 << " " << middle_y + y << "\"/>\n";
        }
    }
    void labels() {
        for (int i = 1; i <= rings; ++i)
            text(middle_x + 4, middle_y - radius * i / rings + 14, "start", scale_ * i / rings);
        for (int degrees = 0; degrees <= 180; degrees += 30) {
            const double angle = degrees_to_radians(degrees), r = radius + 14;
            const double x = r * std::sin(angle), y = middle_y + r * std::cos(angle) + 4;
            text(middle_x + x, y, degrees % 180 == 0 ? "middle" : "start", degrees);
            if (degrees % 180 != 0) text(middle_x - x, y, "end", degrees);
        }
    }
    void curve(double plane, const char* style) {
        out_ << "<path class=\"" << style << "\" d=\"";
        for (int degrees = -180; degrees <= 180; ++degrees) {
            const double cd = intensity(facts_.web, off_axis(facts_.web.type, degrees, plane));
            const double r = radius * cd / scale_, angle = degrees_to_radians(degrees);
            out_ << (degrees == -180 ? "M" : "L") << middle_x + r * std::sin(angle) << " "
                 << middle_y + r * std::cos(angle);
        }
        out_ << "\"/>\n";
    }

private:
    void text(double x, double y, const char* anchor, double value) {
        out_ << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">"
             << value << "</text>\n";
    }

    std::ostream& out_;
    const LuminaireFacts& facts_;
    double scale_;
};

} // namespace

std::string polar_curve_svg(const LuminaireFacts& facts) {
    std::ostringstream out;
    out.precision(5);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << size << " " << size
        << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
        << "<style>circle,path{fill:none;stroke:#bbb}path.main{stroke:#c03;stroke-width:2}"
           "path.across{stroke:#06c;stroke-width:2;stroke-dasharray:6 4}</style>\n"
        << "<rect width=\"" << size << "\" height=\"" << size << "\" fill=\"#fff\"/>\n";
    PolarPlot plot(out, facts);
    plot.grid();
    plot.curve(90, "across");
    plot.curve(0, "main");
    plot.labels();
    const bool c = facts.web.type == PhotometricType::c;
    const std::string title = facts.web.name.empty() ? facts.source : facts.web.name;
    out << "<text x=\"16\" y=\"24\" font-size=\"15\">" << html_escaped(title) << "</text>\n"
        << "<text x=\"16\" y=\"44\">" << facts.flux << " lm; cd; <tspan fill=\"#c03\">"
        << (c ? "C180 | C0" : "horizontal") << "</tspan>, <tspan fill=\"#06c\">dashed "
        << (c ? "C270 | C90" : "vertical") << "</tspan></text>\n</svg>\n";
    return out.str();
}

} // namespace keiko
