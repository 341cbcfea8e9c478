#include "keiko/report/content/picture_outcome.h"

#include "keiko/base/text.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

std::string layer_row(const LayerDifference& layer) {
    const std::string tone = layer.within ? "pass" : "fail";
    return "<tr class=\"" + tone + "\">" + html_text_cell(layer.layer, true) +
           "<td class=\"tone\">" + (layer.within ? "within" : "beyond") + "</td>" +
           html_text_cell(std::to_string(layer.beyond)) +
           html_text_cell(short_number(layer.excess)) +
           html_text_cell(short_number(layer.largest)) +
           html_text_cell(short_number(layer.root_mean_square)) +
           html_text_cell(std::to_string(layer.x) + ", " + std::to_string(layer.y)) + "</tr>";
}

std::string number(double value) {
    return std::isfinite(value) ? short_number(value, 4) : "infinite";
}

std::string flips_text(const PictureOutcome& picture) {
    return counted(picture.coverage_flips, "pixel") + " where the outline moved, " +
           std::to_string(picture.face_flips) + " with another face, of " +
           std::to_string(picture.pixels);
}

std::string layer_text(const LayerDifference& layer) {
    return counted(layer.beyond, "pixel") + " beyond the tolerance; the worst, (" +
           std::to_string(layer.x) + ", " + std::to_string(layer.y) + "), " + number(layer.excess) +
           " times; largest difference " + number(layer.largest);
}

} // namespace

void PictureOutcome::take(const FilmDifference& found) {
    pixels = found.pixels;
    coverage_flips = found.coverage_flips, face_flips = found.face_flips;
    flips_within = found.flips_within;
    layers = found.layers;
}

bool PictureOutcome::within() const {
    return problem.empty() && flips_within &&
           std::all_of(layers.begin(), layers.end(),
                       [](const LayerDifference& layer) { return layer.within; });
}

std::string html_layers(const PictureOutcome& picture) {
    std::string rows;
    for (const LayerDifference& layer : picture.layers) rows += layer_row(layer);
    return "<p class=\"small soft\">" + counted(picture.pixels, "pixel") + "; " +
           std::to_string(picture.coverage_flips) + " where the outline moved, " +
           std::to_string(picture.face_flips) + " others with another face" +
           (picture.flips_within ? "" : ": too many") + "</p>" +
           html_plain_table({"<layer", "", "pixels beyond", "worst, in tolerances",
                             "largest difference", "root mean square", "at pixel"},
                            rows);
}

void add_picture_cases(const PictureOutcome& picture, const std::string& class_name,
                       JunitSuite& suite) {
    const auto add = [&](const std::string& what, bool within, const std::string& message) {
        suite.cases.push_back(judged_case(class_name, picture.view + what, within, message));
    };
    if (!picture.problem.empty()) return add("", false, picture.problem);
    add(": silhouette", picture.flips_within, flips_text(picture));
    for (const LayerDifference& layer : picture.layers)
        add(": " + layer.layer, layer.within, layer_text(layer));
}

} // namespace keiko
