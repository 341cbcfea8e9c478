#include "keiko/report/picture_outcome.h"

#include "keiko/report/html_text.h"
#include "keiko/report/plain_table.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

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

JunitCase flips_case(const PictureOutcome& picture, const std::string& class_name) {
    JunitCase one{class_name, picture.view + ": silhouette"};
    if (picture.flips_within) return one;
    one.outcome = Outcome::failure;
    one.message = std::to_string(picture.coverage_flips) + " pixels where the outline moved, " +
                  std::to_string(picture.face_flips) + " with another face, of " +
                  std::to_string(picture.pixels);
    return one;
}

JunitCase layer_case(const PictureOutcome& picture, const LayerDifference& layer,
                     const std::string& class_name) {
    JunitCase one{class_name, picture.view + ": " + layer.layer};
    if (layer.within) return one;
    one.outcome = Outcome::failure;
    one.message = std::to_string(layer.beyond) + " pixels beyond the tolerance; the worst, (" +
                  std::to_string(layer.x) + ", " + std::to_string(layer.y) + "), " +
                  number(layer.excess) + " times; largest difference " + number(layer.largest);
    return one;
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
    return "<p class=\"small soft\">" + std::to_string(picture.pixels) + " pixels; " +
           std::to_string(picture.coverage_flips) + " where the outline moved, " +
           std::to_string(picture.face_flips) + " others with another face" +
           (picture.flips_within ? "" : ": too many") + "</p>" +
           html_plain_table({"<layer", "", "pixels beyond", "worst, in tolerances",
                             "largest difference", "root mean square", "at pixel"},
                            rows);
}

void add_picture_cases(const PictureOutcome& picture, const std::string& class_name,
                       JunitSuite& suite) {
    if (!picture.problem.empty()) {
        suite.cases.push_back({class_name, picture.view, Outcome::failure, picture.problem});
        return;
    }
    suite.cases.push_back(flips_case(picture, class_name));
    for (const LayerDifference& layer : picture.layers)
        suite.cases.push_back(layer_case(picture, layer, class_name));
}

} // namespace keiko
