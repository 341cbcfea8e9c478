#include "keiko/base/text.h"
#include "keiko/export/sheet_files.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <sstream>

namespace keiko {
namespace {

/// Widths of Helvetica's letters from space to tilde, thousandths of the font size.
constexpr std::array<int, 95> helvetica{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};

/// The text as Latin-1, with '?' for other letters.
std::string latin1(std::string_view text) {
    const std::string letters = one_line(as_utf8(text));
    std::string result;
    for (std::size_t i = 0; i < letters.size();) {
        const std::size_t length = utf8_length(std::string_view(letters).substr(i));
        const char32_t code = length > 0 ? code_point({&letters[i], length}) : U'?';
        result += static_cast<char>(code < 256 ? code : U'?');
        i += length > 0 ? length : 1;
    }
    return result;
}

/// Width of a text of Latin-1, in lengths of its font size.
double width_of(const std::string& text) {
    constexpr int usual = 556;
    int sum = 0;
    for (const char c : text)
        sum += c >= ' ' && c <= '~' ? helvetica.at(std::size_t(c - ' ')) : usual;
    return sum / 1000.0;
}

/// A string of PDF in parentheses.
std::string in_parentheses(const std::string& text) {
    std::string result = "(";
    for (const char c : text) {
        if (c == '(' || c == ')' || c == '\\') result += '\\';
        result += c;
    }
    return result + ')';
}

std::string number(double value) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

/// Content of the page: its user space is in mm.
class PageContent {
public:
    explicit PageContent(const Sheet& sheet) {
        constexpr double points = 72 / 25.4; // a mm
        out_.precision(10);
        out_ << points << " 0 0 " << points << " 0 0 cm 1 J 1 j\n";
        for (std::size_t i = 0; i < sheet.layers.size(); ++i) add(sheet.layers[i], i);
        for (const SheetText& text : sheet.texts) add(text);
    }
    std::string text() const { return out_.str(); }

private:
    void add(const SheetLayer& layer, std::size_t index) {
        out_ << "/OC /L" << index << " BDC " << number(layer.width) << " w "
             << (layer.dashed ? "[2 1]" : "[]") << " 0 d\n";
        for (const std::vector<Vec2>& line : layer.lines) {
            const char* step = " m";
            for (const Vec2& point : line) {
                out_ << number(point.x) << ' ' << number(point.y) << step << '\n';
                step = " l";
            }
            out_ << "S\n";
        }
        out_ << "EMC\n";
    }

    void add(const SheetText& text) {
        constexpr double capital = 0.718; // height of capital letters of Helvetica
        const std::string letters = latin1(text.text);
        const double size = text.height / capital, width = size * width_of(letters);
        const double back = text.anchor == SheetText::Anchor::start    ? 0
                            : text.anchor == SheetText::Anchor::middle ? width / 2
                                                                       : width;
        const Vec2 along = text.upright ? Vec2(1, 0) : Vec2(0, 1);
        const Vec2 at = text.at - along * back;
        out_ << "BT /F1 " << number(size) << " Tf " << along.x << ' ' << along.y << ' ' << -along.y
             << ' ' << along.x << ' ' << number(at.x) << ' ' << number(at.y) << " Tm "
             << in_parentheses(letters) << " Tj ET\n";
    }

    std::ostringstream out_;
};

/// A file of numbered objects, with the table of their places.
class PdfFile {
public:
    PdfFile() { text_ = "%PDF-1.5\n%\xe2\xe3\xcf\xd3\n"; }

    /// Adds the next object, from 1.
    void add(const std::string& object) {
        places_.push_back(text_.size());
        text_ += std::to_string(places_.size()) + " 0 obj\n" + object + "\nendobj\n";
    }
    /// The whole file; object 1 is its catalog.
    std::string closed(const std::string& title) {
        const std::size_t table = text_.size();
        const std::string count = std::to_string(places_.size() + 1);
        text_ += "xref\n0 " + count + "\n0000000000 65535 f \n";
        for (const std::size_t place : places_) {
            std::array<char, 24> entry{};
            std::snprintf(entry.data(), entry.size(), "%010zu 00000 n \n", place);
            text_ += entry.data();
        }
        text_ += "trailer\n<< /Size " + count + " /Root 1 0 R /Info << /Title " +
                 in_parentheses(title) + " >> >>\nstartxref\n" + std::to_string(table) +
                 "\n%%EOF\n";
        return std::move(text_);
    }

private:
    std::string text_;
    std::vector<std::size_t> places_;
};

} // namespace

std::string pdf_sheet(const Sheet& sheet) {
    constexpr std::size_t first_layer = 6; // objects 1 to 5: catalog, pages, page, content, font
    std::string layers, properties;
    for (std::size_t i = 0; i < sheet.layers.size(); ++i) {
        const std::string object = std::to_string(first_layer + i) + " 0 R ";
        layers += object;
        properties += "/L" + std::to_string(i) + ' ' + object;
    }
    constexpr double points = 72 / 25.4; // a mm
    const std::string content = PageContent(sheet).text();
    PdfFile file;
    file.add("<< /Type /Catalog /Pages 2 0 R /OCProperties << /OCGs [ " + layers +
             "] /D << /Order [ " + layers + "] >> >> >>");
    file.add("<< /Type /Pages /Kids [ 3 0 R ] /Count 1 >>");
    file.add("<< /Type /Page /Parent 2 0 R /MediaBox [ 0 0 " + number(sheet.size.x * points) + ' ' +
             number(sheet.size.y * points) +
             " ] /Contents 4 0 R /Resources << /Font << /F1 5 0 R >> /Properties << " + properties +
             ">> >> >>");
    file.add("<< /Length " + std::to_string(content.size()) + " >>\nstream\n" + content +
             "endstream");
    file.add("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>");
    for (const SheetLayer& layer : sheet.layers)
        file.add("<< /Type /OCG /Name " + in_parentheses(latin1(layer.name)) + " >>");
    return file.closed(latin1(sheet.title));
}

} // namespace keiko
