#include "keiko/export/sheet_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace keiko {
namespace {

Sheet small_sheet() {
    Sheet sheet{"a <b> (c) \xc3\xa9", {100, 50}, {}, {}};
    layer_of(sheet, "outlines", 0.5).lines = {{{10, 5}, {20, 5}, {20, 15.25}}};
    layer_of(sheet, "edges hidden", 0.18, true).lines = {{{1, 2}, {3, 4}}};
    sheet.texts = {{{50, 25}, 3, "x & \xc3\xa9 \xe2\x86\x92 (y)", SheetText::Anchor::middle},
                   {{5, 25}, 3, "up", SheetText::Anchor::end, false}};
    return sheet;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(SvgSheet, HasItsLayersInMillimetresFromTheUpperLeftCorner) {
    const std::string svg = svg_sheet(small_sheet());
    EXPECT_TRUE(has(svg, "width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\""));
    EXPECT_TRUE(has(svg,
                    "inkscape:label=\"outlines\"><path stroke-width=\"0.5\" d=\"M10 45l10 0 "
                    "0 -10.25\"/>"));
    EXPECT_TRUE(has(svg, "stroke-width=\"0.18\" stroke-dasharray=\"2 1\" d=\"M1 48l2 -2\"/>"));
    EXPECT_TRUE(has(svg, "<title>a &lt;b&gt; (c) \xc3\xa9</title>"));
    EXPECT_TRUE(has(svg, "text-anchor=\"middle\">x &amp; \xc3\xa9 \xe2\x86\x92 (y)</text>"));
    EXPECT_TRUE(has(svg, "text-anchor=\"end\" transform=\"rotate(-90 5 25)\">up</text>"));
}

TEST(SvgSheet, RoundsPlacesAndNotSteps) {
    Sheet sheet{"", {100, 100}, {}, {}};
    std::vector<Vec2>& line = layer_of(sheet, "edges", 0.1).lines.emplace_back();
    for (int i = 0; i <= 1000; ++i) line.emplace_back(i * 0.0333, 0);
    const std::string svg = svg_sheet(sheet);
    std::istringstream path(svg.substr(svg.find("d=\"M0 100l") + 10));
    double x = 0, step = 0, down = 0;
    while (path >> step >> down) x += step;
    EXPECT_NEAR(x, 33.3, 0.0051);
}

/// Values of the pairs of a DXF file by their codes, in order.
std::vector<std::pair<int, std::string>> pairs_of(const std::string& dxf) {
    std::vector<std::pair<int, std::string>> pairs;
    std::istringstream in(dxf);
    for (std::string code, value; std::getline(in, code) && std::getline(in, value);)
        pairs.emplace_back(std::stoi(code), value);
    return pairs;
}

TEST(DxfSheet, IsPairsOfCodesAndValuesInSections) {
    int open = 0, sections = 0;
    for (const auto& [code, value] : pairs_of(dxf_sheet(small_sheet()))) {
        if (code == 0 && value == "SECTION") ++open, ++sections;
        if (code == 0 && value == "ENDSEC") --open;
        EXPECT_TRUE(open == 0 || open == 1);
    }
    EXPECT_EQ(open, 0);
    EXPECT_EQ(sections, 3);
}

TEST(DxfSheet, HasItsLinesAndTextsOnLayers) {
    const auto pairs = pairs_of(dxf_sheet(small_sheet()));
    std::map<std::string, std::vector<std::string>> by_layer;
    std::string entity;
    std::vector<std::string> line_types;
    for (const auto& [code, value] : pairs) {
        if (code == 0) entity = value;
        if (code == 8) by_layer[value].push_back(entity);
        if (code == 6) line_types.push_back(value);
        for (const char c : value) EXPECT_LT(static_cast<unsigned char>(c), 0x80);
    }
    const std::vector<std::string> three{"POLYLINE", "VERTEX", "VERTEX", "VERTEX", "SEQEND"};
    EXPECT_EQ(by_layer["OUTLINES"], three);
    EXPECT_EQ(by_layer["EDGES-HIDDEN"].size(), 4u);
    EXPECT_EQ(by_layer["TEXTS"], (std::vector<std::string>{"TEXT", "TEXT"}));
    EXPECT_EQ(line_types, (std::vector<std::string>{"CONTINUOUS", "DASHED", "CONTINUOUS"}));
}

TEST(PdfSheet, HasEveryObjectWhereItsTableSays) {
    const std::string pdf = pdf_sheet(small_sheet());
    const std::size_t start = pdf.rfind("startxref\n");
    const std::size_t table = std::stoul(pdf.substr(start + 10));
    std::istringstream in(pdf.substr(table));
    std::string word;
    int first = 0, count = 0;
    in >> word >> first >> count;
    ASSERT_EQ(word, "xref");
    ASSERT_EQ(count, 8); // catalog, pages, page, content, font and two layers, and the free one
    std::string generation, state;
    in >> word >> generation >> state;
    for (int i = 1; i < count; ++i) {
        in >> word >> generation >> state;
        const std::string object = std::to_string(i) + " 0 obj";
        EXPECT_EQ(pdf.substr(std::stoul(word), object.size()), object);
    }
}

TEST(PdfSheet, HasAStreamOfTheLengthItStates) {
    const std::string pdf = pdf_sheet(small_sheet());
    const std::size_t at = pdf.find("/Length ");
    const std::size_t length = std::stoul(pdf.substr(at + 8));
    const std::size_t begin = pdf.find("stream\n", at) + 7;
    EXPECT_EQ(pdf.substr(begin + length, 9), "endstream");
    EXPECT_TRUE(has(pdf, "10.00 5.00 m\n20.00 5.00 l\n20.00 15.25 l\nS"));
    EXPECT_TRUE(has(pdf, "(x & \xe9 ? \\(y\\)) Tj"));
    EXPECT_TRUE(has(pdf, "/Name (edges hidden)"));
}

} // namespace
} // namespace keiko
