#include "keiko/raster/shading_rule.h"
#include "keiko/report/content/mesh_error.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_page.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

constexpr std::string_view mesh_error_style = R"css(
.close-ups { display: grid; grid-template-columns: repeat(auto-fit, minmax(200px, 1fr)); gap: 12px;
  margin-bottom: 16px; }
.close-ups img { display: block; width: 100%; height: auto; image-rendering: pixelated; }
)css";

const SliderWords slider_words{"the mesh", "the surface",
                               "red where it is wrong, blue where it shows another face or none"};

std::string percent(double share) {
    return fixed_number(100 * share, 2) + " %";
}

std::string whole_percent(double share) {
    return fixed_number(100 * share, 0) + " %";
}

std::string mesh_name(const ComparedMesh& mesh) {
    return "mesh of " + short_number(mesh.asked) + " mm";
}

/// "Mesh of 1 mm: 12.30 % of the mirrored pixels wrong; 5 pixels missed, ..." for each.
std::string head(const MeshErrorReport& report) {
    std::string sentences;
    for (std::size_t m = 0; m < report.meshes.size(); ++m)
        sentences += "<div>M" + html_escaped(mesh_name(report.meshes[m]).substr(1)) + ": <b>" +
                     html_escaped(mesh_error_head(report, m)) + "</b>.</div>";
    return "<header class=\"card head\"><div class=\"names\"><h1>" + html_escaped(report.source) +
           "</h1><div class=\"soft\">what meshes show of its reflections; lamps " +
           html_escaped(report.lamps) + "</div>" + sentences + "</div></header>\n";
}

std::string png_image(const MeshErrorReport& report, const std::string& name,
                      const std::string& words) {
    return "<img alt=\"" + html_escaped(words) + "\" src=\"data:image/png;base64," +
           base64(report.pngs.at(name)) + "\">";
}

std::string close_up(const MeshErrorReport& report, const std::string& name,
                     const std::string& words) {
    return "<figure class=\"card\">" + png_image(report, name, words) + "<figcaption>" +
           html_escaped(words) + "</figcaption></figure>";
}

std::string close_ups(const MeshErrorReport& report, const MeshErrorView& view) {
    if (view.close_up.empty())
        return "<p class=\"soft small\">The coarsest mesh mirrors no pixel wrong.</p>";
    std::string row;
    for (std::size_t m = 0; m < view.meshes.size(); ++m)
        row += close_up(report, view.meshes[m].close_up, mesh_name(report.meshes[m]));
    return "<p class=\"soft small\">Where the coarsest mesh is wrong most, " +
           short_number(view.magnification) + " times as large:</p><div class=\"close-ups\">" +
           row + close_up(report, view.close_up, "the surface itself") + "</div>";
}

std::string sliders(const MeshErrorReport& report, const MeshErrorView& view) {
    std::string html;
    for (std::size_t m = 0; m < view.meshes.size(); ++m) {
        const MeshErrorPictures& mesh = view.meshes[m];
        const SliderPictures pictures{report.pngs.at(mesh.mirror),
                                      report.pngs.at(view.truth),
                                      report.pngs.at(mesh.wrong),
                                      view.width,
                                      view.height,
                                      slider_words};
        html += html_slider(pictures, mesh_name(report.meshes[m]));
    }
    return html;
}

std::string cells(const std::vector<std::string>& texts) {
    std::string row;
    for (const std::string& text : texts) row += html_text_cell(text);
    return row;
}

std::string pixel_cells(const MeshErrors& e) {
    const auto of_inside = [](const FacePixels& pixels) {
        return std::to_string(pixels.all) + " (" + std::to_string(pixels.inside) + ")";
    };
    const double compared = static_cast<double>(e.compared);
    const auto share = [&](std::size_t count) {
        return e.compared > 0 ? percent(static_cast<double>(count) / compared) : "–";
    };
    return cells({std::to_string(e.compared), share(e.wrong), share(e.reversed),
                  of_inside(e.missed), of_inside(e.added), of_inside(e.other_face)});
}

std::string size_cells(const MeshErrors& e) {
    std::vector<std::string> texts;
    for (const SizeQuantiles& sizes : {e.pixels, e.on_part, e.at_lamps, e.normal})
        for (const double size : {sizes.median, sizes.p99}) texts.push_back(short_number(size));
    return cells(texts);
}

std::string band_cells(const FacetBands& bands) {
    std::vector<std::string> texts{std::to_string(bands.places),
                                   fixed_number(100 * bands.truth, 3)};
    for (const MeshShading shading :
         {MeshShading::phong, MeshShading::gouraud, MeshShading::constant})
        texts.push_back(fixed_number(100 * bands.mesh[static_cast<std::size_t>(shading)], 3));
    return cells(texts);
}

/// A table with a row for each mesh of a view; `of`(pictures) has the cells after its name.
template <class Cells>
std::string table(const MeshErrorReport& report, const MeshErrorView& view,
                  std::vector<std::string> headings, const Cells& of) {
    headings.insert(headings.begin(), "<mesh");
    std::string rows;
    for (std::size_t m = 0; m < view.meshes.size(); ++m)
        rows += "<tr>" + html_text_cell(mesh_name(report.meshes[m]), true) + of(view.meshes[m]) +
                "</tr>";
    return html_plain_table(headings, rows);
}

std::string view_section(const MeshErrorReport& report, const MeshErrorView& view) {
    using Mesh = MeshErrorPictures;
    std::string html = close_ups(report, view) + sliders(report, view);
    html += table(report, view,
                  {"pixels compared", "wrong", "reversed", "missed (inside)", "added (inside)",
                   "other face (inside)"},
                  [](const Mesh& mesh) { return pixel_cells(mesh.errors); });
    html +=
        "<p class=\"soft small\">Displacement of the mirrored lamps: half of the pixels within, "
        "99 % within.</p>" +
        table(report, view,
              {"px, half", "px, 99 %", "mm on part, half", "mm on part, 99 %", "mm at lamps, half",
               "mm at lamps, 99 %", "normal ″, half", "normal ″, 99 %"},
              [](const Mesh& mesh) { return size_cells(mesh.errors); });
    html +=
        "<p class=\"soft small\">Mach bands at facet borders: second difference of the "
        "luminance under a lamp at the eye, % of its largest, 99 % within.</p>" +
        table(report, view, {"borders", "the surface", "Phong", "Gouraud", "constant"},
              [](const Mesh& mesh) { return band_cells(mesh.bands); });
    return html_section(view.name, html);
}

std::string meshes(const MeshErrorReport& report) {
    std::string rows, lost;
    for (const ComparedMesh& mesh : report.meshes) {
        rows += "<tr>" + html_text_cell(short_number(mesh.asked)) +
                html_text_cell(short_number(mesh.deviation)) +
                html_text_cell(std::to_string(mesh.triangles)) +
                html_text_cell(std::to_string(mesh.lost_faces.size())) + "</tr>";
        for (const std::string& face : mesh.lost_faces)
            lost += "<li>" + html_escaped(mesh_name(mesh) + ": " + face) + "</li>";
    }
    return html_plain_table({"asked, mm", report.proved ? "proved, mm" : "measured, mm",
                             "triangles", "faces lost"},
                            rows) +
           (lost.empty() ? "" : "<ul>" + lost + "</ul>");
}

std::string meaning(const MeshErrorReport& report) {
    const std::string normals =
        report.averaged_normals
            ? "normals at their corners that are averaged within each face over the triangles "
              "around"
            : "the surface’s own normals at their corners, as a good viewport has them";
    return "<p>Both sides of each slider mirror the same lamps to the same eye. Only the surface "
           "differs: the exact one, or triangles with " +
           normals +
           ".</p>"
           "<p>A pixel is wrong if lamps fill another share of it, by more than " +
           whole_percent(wrong_coverage) + ". It is reversed beyond " +
           whole_percent(reversed_coverage) +
           ". Wrong pixels are red in the pictures beside the sliders, pixels of another face "
           "or "
           "none blue.</p>"
           "<p>Pixels inside lie off all edges: their neighbours show one face. There a mesh has "
           "holes or laps.</p>";
}

} // namespace

std::string mesh_error_html(const MeshErrorReport& report) {
    std::string html = head(report);
    for (const MeshErrorView& view : report.views) html += view_section(report, view);
    html += html_section("Meshes", meshes(report));
    html += html_section("What is compared", meaning(report));
    html += "<footer><p>Neither side mirrors the part itself or casts shadows.</p><p>Keiko " +
            html_escaped(report.tool_version) + "</p></footer>\n";
    return html_page("meshes", std::string(slider_style) + std::string(mesh_error_style), html);
}

} // namespace keiko
