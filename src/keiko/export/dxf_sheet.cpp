#include "keiko/base/text.h"
#include "keiko/export/sheet_files.h"

#include <array>
#include <cstdio>
#include <sstream>

namespace keiko {
namespace {

/// Writer of DXF's pairs of lines: a group code and its value.
class DxfWriter {
public:
    void add(int code, std::string_view text) { out_ << code << '\n' << text << '\n'; }
    void add(int code, int value) { out_ << code << '\n' << value << '\n'; }
    void add(int code, double value) {
        std::array<char, 48> text{};
        std::snprintf(text.data(), text.size(), "%.3f", value);
        out_ << code << '\n' << text.data() << '\n';
    }
    void add_point(int code, const Vec2& at) { add(code, at.x), add(code + 10, at.y); }
    void begin(std::string_view section) { add(0, "SECTION"), add(2, section); }
    void end() { add(0, "ENDSEC"); }
    void begin_table(std::string_view table, int entries) {
        add(0, "TABLE"), add(2, table), add(70, entries);
    }
    void end_table() { add(0, "ENDTAB"); }
    std::string text() const { return out_.str(); }

private:
    std::ostringstream out_;
};

/// Name of a layer as release 12 allows it: capitals and hyphens.
std::string layer_name(const std::string& name) {
    std::string letters = name;
    for (char& c : letters) {
        if (c == ' ') c = '-';
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return letters;
}

/// The text with '?' for each letter that is not in ASCII.
std::string ascii(std::string_view text) {
    std::string result;
    const std::string letters = one_line(as_utf8(text));
    for (const char c : letters) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) result += c;
        if (byte >= 0xc0) result += '?';
    }
    return result;
}

void add_header(DxfWriter& out, const Sheet& sheet) {
    out.begin("HEADER");
    out.add(9, "$ACADVER"), out.add(1, "AC1009");
    out.add(9, "$EXTMIN"), out.add_point(10, Vec2(0));
    out.add(9, "$EXTMAX"), out.add_point(10, sheet.size);
    out.add(9, "$LTSCALE"), out.add(40, 1.0);
    out.end();
}

void add_line_types(DxfWriter& out) {
    constexpr double dash = 2, space = 1; // mm
    out.begin_table("LTYPE", 2);
    out.add(0, "LTYPE"), out.add(2, "CONTINUOUS"), out.add(70, 0), out.add(3, "Solid line");
    out.add(72, 65), out.add(73, 0), out.add(40, 0.0);
    out.add(0, "LTYPE"), out.add(2, "DASHED"), out.add(70, 0), out.add(3, "__ __ __");
    out.add(72, 65), out.add(73, 2), out.add(40, dash + space), out.add(49, dash);
    out.add(49, -space);
    out.end_table();
}

void add_layers(DxfWriter& out, const Sheet& sheet) {
    constexpr int black = 7, grey = 8; // colours by number
    out.begin_table("LAYER", static_cast<int>(sheet.layers.size()) + 1);
    const auto add = [&](const std::string& name, bool dashed) {
        out.add(0, "LAYER"), out.add(2, name), out.add(70, 0);
        out.add(62, dashed ? grey : black), out.add(6, dashed ? "DASHED" : "CONTINUOUS");
    };
    for (const SheetLayer& layer : sheet.layers) add(layer_name(layer.name), layer.dashed);
    add("TEXTS", false);
    out.end_table();
}

void add_polyline(DxfWriter& out, const SheetLayer& layer, const std::vector<Vec2>& line) {
    const std::string name = layer_name(layer.name);
    out.add(0, "POLYLINE"), out.add(8, name), out.add(66, 1);
    out.add_point(10, Vec2(0)), out.add(30, 0.0);
    out.add(70, layer.dashed ? 128 : 0); // dashes run on over the vertices
    out.add(40, layer.width), out.add(41, layer.width);
    for (const Vec2& point : line) {
        out.add(0, "VERTEX"), out.add(8, name);
        out.add_point(10, point), out.add(30, 0.0);
    }
    out.add(0, "SEQEND"), out.add(8, name);
}

void add_text(DxfWriter& out, const SheetText& text) {
    out.add(0, "TEXT"), out.add(8, "TEXTS");
    out.add_point(10, text.at), out.add(30, 0.0), out.add(40, text.height);
    out.add(1, ascii(text.text)), out.add(50, text.upright ? 0.0 : 90.0);
    if (text.anchor == SheetText::Anchor::start) return;
    out.add(72, text.anchor == SheetText::Anchor::middle ? 1 : 2);
    out.add_point(11, text.at), out.add(31, 0.0);
}

} // namespace

std::string dxf_sheet(const Sheet& sheet) {
    DxfWriter out;
    add_header(out, sheet);
    out.begin("TABLES");
    add_line_types(out);
    add_layers(out, sheet);
    out.end();
    out.begin("ENTITIES");
    for (const SheetLayer& layer : sheet.layers)
        for (const std::vector<Vec2>& line : layer.lines) add_polyline(out, layer, line);
    for (const SheetText& text : sheet.texts) add_text(out, text);
    out.end();
    out.add(0, "EOF");
    return out.text();
}

} // namespace keiko
