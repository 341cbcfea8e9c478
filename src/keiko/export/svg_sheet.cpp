#include "keiko/export/sheet_files.h"
#include "keiko/export/svg_path.h"
#include "keiko/report/markup/html_text.h"

#include <sstream>

namespace keiko {
namespace {

void add_layer(std::ostream& out, const SheetLayer& layer, double height) {
    constexpr int decimals = 2; // of a mm
    out << "<g id=\"" << html_escaped(layer.name) << "\" inkscape:groupmode=\"layer\""
        << " inkscape:label=\"" << html_escaped(layer.name) << "\"><path stroke-width=\""
        << layer.width << '"';
    if (layer.dashed) out << " stroke-dasharray=\"2 1\"";
    out << " d=\"" << svg_path(layer.lines, height, decimals) << "\"/></g>\n";
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
