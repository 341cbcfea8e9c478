#include "keiko/compare_bodies.h"

#include <cmath>
#include <cstdio>

namespace keiko {
namespace {

constexpr double mostly = 0.5;

std::vector<std::string> turned_faces(const PlacedModel& body, const Deviation& deviation) {
    std::vector<std::string> names;
    for (std::size_t f = 0; f < deviation.turned.size(); ++f)
        if (deviation.turned[f] > mostly) names.push_back(body.model.describe(body.model.faces[f]));
    return names;
}

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

std::string place(const Vec3& p) {
    return "(" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")";
}

std::string deviation_text(const std::string& what, const Deviation& d) {
    std::string text = what + ": at most " + number(d.worst.value) + " mm at " +
                       place(d.worst.place) + "; 99 % of the area within " + number(d.percent_99) +
                       " mm, half within " + number(d.median) + " mm";
    if (d.uncertain_share > 0)
        text += "; not proved on " + number(100 * d.uncertain_share) + " % of the area";
    return text + "\n";
}

/// "face 1 (left) and face 2 (right)"
std::string sides_of(std::string faces) {
    if (const std::size_t bar = faces.find(" | "); bar != std::string::npos)
        faces.replace(bar, 3, " and ");
    return faces;
}

std::string change_text(const MeasuredSeam& before, const MeasuredSeam& after) {
    std::string text = "seam of " + sides_of(after.faces) + ": gap " + number(before.gap.value) +
                       " mm before, " + number(after.gap.value) + " mm after";
    if (before.angle && after.angle)
        text += "; angle " + number(before.angle->value) + " degrees before, " +
                number(after.angle->value) + " after";
    return text + "; " + std::string(name_of(before.verdict)) + " before, " +
           std::string(name_of(after.verdict)) + " after\n";
}

std::string seams_text(const BodyComparison& c) {
    std::string text;
    for (const SeamChange& change : c.seams.changed)
        text += change_text(c.inspection_before.seams[change.before],
                            c.inspection_after.seams[change.after]);
    for (const std::uint32_t seam : c.seams.removed)
        text += "seam gone: " + sides_of(c.inspection_before.seams[seam].faces) + "\n";
    for (const std::uint32_t seam : c.seams.added)
        text += "seam new: " + sides_of(c.inspection_after.seams[seam].faces) + "\n";
    for (const Check& finding : c.seams.new_findings)
        text += "finding new: " + sides_of(finding.faces) + ": " + finding.message + "\n";
    for (const Check& finding : c.seams.solved_findings)
        text += "finding fixed: " + sides_of(finding.faces) + ": " + finding.message + "\n";
    return text;
}

bool within(const Deviation& d, const BodyTolerance& tolerance) {
    return std::abs(d.worst.value) <= tolerance.deviation &&
           d.worst_border.value <= tolerance.deviation && d.worst_normal.value <= tolerance.normal;
}

} // namespace

bool BodyComparison::same() const {
    return within(deviation, tolerance) && within(missing, tolerance) && turned.empty() &&
           faces_before == faces_after && seams.empty();
}

BodyComparison compare_bodies(const std::filesystem::path& before,
                              const std::filesystem::path& after,
                              const CompareBodiesOptions& options, const Job& job) {
    const SurfaceModel a = load_model(before, options.load, job);
    const SurfaceModel b = load_model(after, options.load, job);
    const SurfaceFeet feet_a(placed_model(a), job), feet_b(placed_model(b), job);
    BodyComparison result;
    result.before = before.string(), result.after = after.string();
    result.tolerance = options.tolerance;
    result.deviation = measure_deviation(feet_b, feet_a, options.deviation, job);
    result.missing = measure_deviation(feet_a, feet_b, options.deviation, job);
    result.faces_before = feet_a.body().model.faces.size();
    result.faces_after = feet_b.body().model.faces.size();
    result.turned = turned_faces(feet_b.body(), result.deviation);
    result.inspection_before = inspect(a, options.preset, options.join, job);
    result.inspection_after = inspect(b, options.preset, options.join, job);
    result.seams =
        compare_inspections(result.inspection_before, result.inspection_after, options.seams);
    return result;
}

std::string comparison_text(const BodyComparison& c) {
    std::string text = c.same() ? "same within tolerance\n" : "different\n";
    text += deviation_text("deviation of " + c.after, c.deviation);
    text += deviation_text("deviation of " + c.before + " from it", c.missing);
    text += "normals: at most " + number(c.deviation.worst_normal.value) + " degrees apart at " +
            place(c.deviation.worst_normal.place) + "\n";
    text += "borders: at most " + number(c.deviation.worst_border.value) + " mm apart at " +
            place(c.deviation.worst_border.place) + ", seen from before at most " +
            number(c.missing.worst_border.value) + " mm at " + place(c.missing.worst_border.place) +
            "\n";
    if (c.faces_before != c.faces_after)
        text += "faces: " + std::to_string(c.faces_before) + " before, " +
                std::to_string(c.faces_after) + " after\n";
    for (const std::string& face : c.turned) text += "turned inside out: " + face + "\n";
    return text + seams_text(c);
}

} // namespace keiko
