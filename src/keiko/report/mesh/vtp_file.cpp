#include "keiko/geometry/bezier/space_curve.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/report/content/mesh_files.h"
#include "keiko/report/markup/html_text.h"

#include <cstring>
#include <span>

namespace keiko {
namespace {

/// Arrays of a VTK XML file, each in base64 after the number of its bytes.
class VtpText {
public:
    void open(const std::string& tag) { text_ += "<" + tag + ">\n"; }
    void close(const std::string& tag) { text_ += "</" + tag + ">\n"; }

    template <class Number>
    void array(const std::string& name, const char* type, int components,
               std::span<const Number> numbers) {
        const std::uint64_t size = numbers.size_bytes();
        std::string bytes(sizeof size + size, '\0');
        std::memcpy(bytes.data(), &size, sizeof size);
        if (size > 0) std::memcpy(bytes.data() + sizeof size, numbers.data(), size);
        text_ += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + html_escaped(name) +
                 "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"binary\">" +
                 base64(bytes) + "</DataArray>\n";
    }
    void vectors(const std::string& name, const std::vector<Vec3>& vectors) {
        std::vector<double> numbers;
        for (const Vec3& v : vectors) numbers.insert(numbers.end(), {v.x, v.y, v.z});
        array<double>(name, "Float64", 3, numbers);
    }
    void numbers(const std::string& name, const std::vector<double>& values) {
        array<double>(name, "Float64", 1, values);
    }
    void indices(const std::string& name, const std::vector<std::int64_t>& values) {
        array<std::int64_t>(name, "Int64", 1, values);
    }
    /// Texts as VTK writes them: the codes of their bytes, each ended by 0.
    void texts(const std::string& name, const std::vector<std::string>& words) {
        text_ += "<Array type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" +
                 std::to_string(words.size()) + "\" format=\"ascii\">";
        for (const std::string& word : words) {
            for (const char c : word) text_ += std::to_string(static_cast<unsigned char>(c)) + " ";
            text_ += "0 ";
        }
        text_ += "</Array>\n";
    }
    /// The file of one piece.
    std::string file(std::size_t points, std::size_t lines, std::size_t polygons,
                     const std::string& before) const {
        return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n" +
               before + "<Piece NumberOfPoints=\"" + std::to_string(points) +
               "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(lines) +
               "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(polygons) + "\">\n" +
               text_ + "</Piece>\n</PolyData>\n</VTKFile>\n";
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// Points of a Bezier segment after its first, halved until its control points lie within
/// `chord_error` of the chord.
void append_chords(const CurvePoints& segment, double chord_error, int halvings,
                   std::vector<Vec3>& points) {
    const Vec3 begin = euclidean(segment.front()), end = euclidean(segment.back());
    double off = 0;
    for (const Vec4& p : segment) off = std::max(off, segment_distance(begin, end, euclidean(p)));
    if (off <= chord_error || halvings == 0) {
        points.push_back(end);
        return;
    }
    CurvePoints lower, upper, row = segment;
    while (!row.empty()) {
        lower.push_back(row.front()), upper.insert(upper.begin(), row.back());
        for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = (row[i] + row[i + 1]) * 0.5;
        row.pop_back();
    }
    append_chords(lower, chord_error, halvings - 1, points);
    append_chords(upper, chord_error, halvings - 1, points);
}

std::vector<Vec3> polyline(const NurbsCurve<Vec4>& curve, double chord_error) {
    constexpr int most_halvings = 20;
    std::vector<Vec3> points;
    for (const BezierSpan<Vec4>& span : bezier_spans(curve)) {
        if (points.empty()) points.push_back(euclidean(span.points.front()));
        append_chords(span.points, chord_error, most_halvings, points);
    }
    return points;
}

/// Numbers from 0 up to `count`.
std::vector<std::int64_t> rising(std::size_t count) {
    std::vector<std::int64_t> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<std::int64_t>(i);
    return all;
}

} // namespace

std::string vtp_file(const SurfaceMesh& mesh) {
    std::vector<std::int64_t> corners, ends, faces(mesh.faces.begin(), mesh.faces.end());
    for (const auto& triangle : mesh.triangles) {
        corners.insert(corners.end(), triangle.begin(), triangle.end());
        ends.push_back(static_cast<std::int64_t>(corners.size()));
    }
    VtpText text, facts;
    facts.open("FieldData");
    facts.numbers("deviation_mm", {mesh.deviation});
    facts.close("FieldData");
    text.open("PointData Normals=\"normal\"");
    text.vectors("normal", mesh.normals);
    for (const MeshField& field : mesh.fields) text.numbers(field.name, field.values);
    text.close("PointData");
    text.open("CellData");
    text.indices("face", faces);
    text.close("CellData");
    text.open("Points");
    text.vectors("Points", mesh.positions);
    text.close("Points");
    text.open("Polys");
    text.indices("connectivity", corners);
    text.indices("offsets", ends);
    text.close("Polys");
    return text.file(mesh.positions.size(), 0, mesh.triangles.size(), facts.text());
}

std::string vtp_file(const CurveSet& curves, double chord_error) {
    std::vector<Vec3> points;
    std::vector<std::int64_t> ends, numbers;
    std::vector<double> deviations, colors;
    std::vector<std::string> names;
    for (const NamedCurve& curve : curves.curves) {
        for (const NurbsCurve<Vec4>& piece : curve.pieces) {
            const std::vector<Vec3> line = polyline(piece, chord_error);
            points.insert(points.end(), line.begin(), line.end());
            ends.push_back(static_cast<std::int64_t>(points.size()));
            numbers.push_back(static_cast<std::int64_t>(names.size()));
            deviations.push_back(curve.deviation + chord_error);
            const Rgb color = curve.color.value_or(Rgb(0.5));
            colors.insert(colors.end(), {color.r, color.g, color.b});
        }
        names.push_back(curve.name);
    }
    VtpText text, facts;
    facts.open("FieldData");
    facts.texts("names", names);
    facts.close("FieldData");
    text.open("CellData");
    text.indices("curve", numbers);
    text.numbers("deviation_mm", deviations);
    text.array<double>("color", "Float64", 3, colors);
    text.close("CellData");
    text.open("Points");
    text.vectors("Points", points);
    text.close("Points");
    text.open("Lines");
    text.indices("connectivity", rising(points.size()));
    text.indices("offsets", ends);
    text.close("Lines");
    return text.file(points.size(), ends.size(), 0, facts.text());
}

} // namespace keiko
