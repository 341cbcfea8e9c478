#include "tests/bench/three_lights.h"

#include "keiko/files/scene/material_file.h"
#include "keiko/film/image_file.h"
#include "keiko/film/overlay.h"
#include "keiko/film/tone_mapping.h"

#include "tests/support/light_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace keiko::bench {
namespace {

using namespace test;

struct Row {
    Defect defect;
    const char* name;
    double least, most; ///< between which sizes it is looked for
};
constexpr Row rows[] = {{Defect::dent, "dent 80 mm wide, mm", 1e-4, 10},
                        {Defect::wave, "waves 100 mm long, mm", 1e-4, 10},
                        {Defect::kink, "angle at a seam, degrees", 1e-3, 30},
                        {Defect::bend, "jump of curvature, 1/m", 1e-3, 30},
                        {Defect::ramp, "jump of its slope, 1/m²", 1e-1, 3e3}};
constexpr double step = 1.2;
constexpr int trial_height = 360; ///< px
constexpr const char* black = "black-show-car";

Material paint(const char* name) {
    const auto& all = standard_materials();
    return *std::find_if(all.begin(), all.end(),
                         [&](const Material& material) { return material.name == name; });
}

std::string two_digits(double value) {
    if (!std::isfinite(value)) return "none";
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    // No powers of ten where digits do.
    if (value >= 100) std::snprintf(text, sizeof text, "%.0f", std::strtod(text, nullptr));
    return text;
}

void place(Image& sheet, const Image& picture, int left, int top) {
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.pixel(0, y), 3 * picture.width, sheet.pixel(left, top + y));
}

} // namespace

Table three_lights_table() {
    Table table;
    table.head = {"defect", "paint"};
    table.left = 2;
    for (const TrialLight light : trial_lights) table.head.emplace_back(test::name_of(light));
    for (const char* name : {black, "silver", "white"}) {
        const LightTrial trial(paint(name), trial_height);
        for (const Row& row : rows) {
            std::vector<std::string> cells{row.name, name};
            for (const TrialLight light : trial_lights) {
                const auto t = trial.threshold(light, row.defect, row.least, row.most, step);
                cells.push_back(two_digits(t.somewhere) + " / " + two_digits(t.everywhere));
            }
            table.rows.push_back(std::move(cells));
        }
    }
    std::stable_sort(table.rows.begin(), table.rows.end(),
                     [](const auto& a, const auto& b) { return a[0] < b[0]; });
    return table;
}

Table seen_lines_table() {
    Table table;
    table.head = {"seen everywhere from", "size", "turn, °", "jump, mm", "kink, °", "bend, 1/mm"};
    const LightTrial trial(paint(black), trial_height);
    for (const Row& row : rows) {
        if (!is_at_seam(row.defect)) continue;
        const double size =
            trial.threshold(TrialLight::tubes, row.defect, row.least, row.most, step).everywhere;
        double turn = 0, jump = 0, kink = 0, bend = 0;
        const auto keep = [](double& most, const LineValue& value) {
            most = std::max(most, std::abs(value.value));
        };
        for (const LineCrossing& c : trial.crossings(row.defect, size))
            keep(turn, c.turn), keep(jump, c.jump), keep(kink, c.kink), keep(bend, c.bend);
        table.rows.push_back({row.name, two_digits(size), two_digits(turn), two_digits(jump),
                              two_digits(kink), two_digits(bend)});
    }
    return table;
}

void draw_three_lights(const std::filesystem::path& output) {
    require_image_extension(output);
    constexpr int height = 300, gap = 8, band = 26;
    constexpr double depth = 0.1; // mm
    const LightTrial trial(paint(black), height);
    const int width = height * 3 / 2;
    Image sheet(3 * width + 4 * gap, height + band + gap, 3, 1.0F);
    Overlay labels;
    int left = gap;
    for (const TrialLight light : trial_lights) {
        const Film film = trial.picture(light, Defect::dent, depth);
        place(sheet, tone_mapped(film), left, band);
        labels.texts.push_back(
            {.at = Vec2(left, 6), .text = test::name_of(light), .color = Rgb(0.1)});
        left += width + gap;
    }
    write_png(output, with_overlay(std::move(sheet), labels));
}

} // namespace keiko::bench
