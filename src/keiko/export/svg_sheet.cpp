#include "keiko/export/sheet_files.h"
#include "keiko/report/markup/html_text.h"

#include <cmath>
#include <sstream>

namespace keiko {
namespace {

/// Writes hundredths of a mm in as few letters as SVG allows.
class PathWriter {
public:
    explicit PathWriter(double height) : height_(height) {}

    void add(const std::vector<Vec2>& line) {
        long long x = hundredths(line[0].x), y = hundredths(height_ - line[0].y);
        text_ << 'M' << number(x) << ' ' << number(y) << 'l';
        bool first = true;
        for (std::size_t i = 1; i < line.size(); ++i) {
            const long long next_x = hundredths(line[i].x),
                            next_y = hundredths(height_ - line[i].y);
            if (next_x == x && next_y == y && (i + 1 < line.size() || !first)) continue;
            if (!first) text_ << ' ';
            text_ << number(next_x - x) << ' ' << number(next_y - y);
            x = next_x, y = next_y, first = false;
        }
    }
    std::string text() const { return text_.str(); }

private:
    static long long hundredths(double mm) { return std::llround(mm * 100); }

    static std::string number(long long hundredths) {
        const long long size = std::abs(hundredths);
        std::string text = hundredths < 0 ? "-" : "";
        if (size >= 100 || size % 100 == 0) text += std::to_string(size / 100);
        if (size % 100 == 0) return text;
        text += '.';
        text += static_cast<char>('0' + size / 10 % 10);
        if (size % 10 != 0) text += static_cast<char>('0' + size % 10);
        return text;
    }

    double height_;
    std::ostringstream text_;
};

void add_layer(std::ostream& out, const SheetLayer& layer, double height) {
    PathWriter path(height);
    for (const std::vector<Vec2>& line : layer.lines) path.add(line);
    out << "<g id=\"" << html_escaped(layer.name) << "\" inkscape:groupmode=\"layer\""
        << " inkscape:label=\"" << html_escaped(layer.name) << "\"><path stroke-width=\""
        << layer.width << '"';
    if (layer.dashed) out << " stroke-dasharray=\"2 1\"";
    out << " d=\"" << path.text() << "\"/></g>\n";
}

void add_text(std::ostream& out, const SheetText& text, double height) {
    constexpr double capital = 0.72; // height of capital letters in one of the font
    const char* const anchor = text.anchor == SheetText::Anchor::start    ? "start"
                               : text.anchor == SheetText::Anchor::middle ? "middle"
                                                                          : "end";
    const double x = text.at.x, y = height - text.at.y;
    out << "<text x=\"" << x << "\" y=\"" << y << "\" font-size=\"" << text.height / capital
        << "\" text-anchor=\"" << anchor << '"';
    if (!text.upright) out << " transform=\"rotate(-90 " << x << ' ' << y << ")\"";
    out << '>' << html_escaped(text.text) << "</text>\n";
}

} // namespace

std::string svg_sheet(const Sheet& sheet) {
    std::ostringstream out;
    out.precision(6);
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        << "<svg xmlns=\"http://www.w3.org/2000/svg\""
        << " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\""
        << " width=\"" << sheet.size.x << "mm\" height=\"" << sheet.size.y << "mm\" viewBox=\"0 0 "
        << sheet.size.x << ' ' << sheet.size.y << "\">\n<title>" << html_escaped(sheet.title)
        << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        << "<g fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (const SheetLayer& layer : sheet.layers) add_layer(out, layer, sheet.size.y);
    out << "</g>\n<g id=\"texts\" inkscape:groupmode=\"layer\" inkscape:label=\"texts\""
        << " font-family=\"Helvetica, Arial, sans-serif\">\n";
    for (const SheetText& text : sheet.texts) add_text(out, text, sheet.size.y);
    out << "</g>\n</svg>\n";
    return out.str();
}

} // namespace keiko
