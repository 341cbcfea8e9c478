#include "keiko/report/content/scan_comparison.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace keiko {
namespace {

/// Units of the picture.
constexpr double width = 760, height = 190, left = 8, right = 8, head = 8, foot = 26;

/// Draws the bars of a histogram, and its axis from the lowest edge to the highest.
class HistogramDrawing {
public:
    HistogramDrawing(const DeviationHistogram& histogram, std::optional<double> tolerance)
        : histogram_(histogram), tolerance_(tolerance) {}

    std::string svg() {
        svg_ << "<svg class=\"histogram\" viewBox=\"0 0 " << width << ' ' << height
             << "\" role=\"img\" aria-label=\"histogram of the deviations\">";
        const std::size_t most =
            *std::max_element(histogram_.counts.begin(), histogram_.counts.end());
        for (std::size_t i = 0; i < histogram_.counts.size(); ++i) bar(i, most);
        svg_ << "<path class=\"axis\" d=\"M" << left << ' ' << height - foot << "H" << width - right
             << "\"/>";
        const double end = -histogram_.lowest;
        for (const double value : {-end, -end / 2, 0.0, end / 2, end}) tick(value);
        if (tolerance_)
            for (const double value : {-*tolerance_, *tolerance_}) limit(value);
        svg_ << "</svg>\n";
        return svg_.str();
    }

private:
    double x(double value) const {
        const double span = histogram_.width * static_cast<double>(histogram_.counts.size());
        return left + (value - histogram_.lowest) / span * (width - left - right);
    }
    void bar(std::size_t i, std::size_t most) {
        const double from = histogram_.lowest + histogram_.width * static_cast<double>(i);
        const double middle = from + histogram_.width / 2;
        const bool out = tolerance_ && std::abs(middle) > *tolerance_;
        const double high = static_cast<double>(histogram_.counts[i]) / static_cast<double>(most) *
                            (height - head - foot);
        svg_ << "<rect class=\"" << (out ? "out" : "in") << "\" x=\"" << x(from) + 0.5 << "\" y=\""
             << height - foot - high << "\" width=\"" << x(from + histogram_.width) - x(from) - 1
             << "\" height=\"" << high << "\"><title>" << short_number(from) << " to "
             << short_number(from + histogram_.width) << " mm: " << histogram_.counts[i]
             << "</title></rect>";
    }
    void tick(double value) {
        const char* anchor = value == histogram_.lowest    ? "start"
                             : value == -histogram_.lowest ? "end"
                                                           : "middle";
        svg_ << "<text x=\"" << x(value) << "\" y=\"" << height - 8 << "\" text-anchor=\"" << anchor
             << "\">" << short_number(value) << " mm</text>";
    }
    void limit(double value) {
        svg_ << "<path class=\"limit\" d=\"M" << x(value) << ' ' << head << "V" << height - foot
             << "\"/>";
    }

    const DeviationHistogram& histogram_;
    std::optional<double> tolerance_;
    std::ostringstream svg_;
};

} // namespace

std::string histogram_svg(const ScanComparison& c) {
    if (c.deviation.measured == 0) return "";
    return HistogramDrawing(c.deviation.histogram, c.limits.tolerance).svg();
}

} // namespace keiko
