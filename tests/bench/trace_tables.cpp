#include "tests/bench/trace_tables.h"

#include <utility>

namespace keiko::bench {
namespace {

std::vector<std::string> accuracy_cells(const std::optional<Accuracy>& accuracy) {
    if (!accuracy) return {"", "", "", "", ""};
    const Accuracy& a = *accuracy;
    std::vector<std::string> cells{share(a.missed, a.hits), share(a.false_hits, a.rays),
                                   digits(a.normal_p50) + " / " + digits(a.normal_p99),
                                   digits(a.lateral_p99), ""};
    if (a.zebra)
        cells.back() =
            digits(a.zebra->p50) + " / " + digits(a.zebra->p99) + " / " + digits(a.zebra->p999);
    return cells;
}

std::vector<std::string> rate_cells(const std::string& rays, const Measurement& m) {
    const std::string ratio = m.kind == Kind::opencascade
                                  ? digits(m.keiko_single) + " / " + digits(m.keiko_packets)
                                  : digits(m.ratio());
    std::vector<std::string> cells{
        rays, m.name, name_of(m.mode), digits(m.rate / 1e6), ratio, digits(m.crossings)};
    for (std::string& cell : accuracy_cells(m.accuracy)) cells.push_back(std::move(cell));
    return cells;
}

const Measurement* find(const SceneResult& scene, const std::string& rays, const std::string& name,
                        Mode mode) {
    for (const ClassResult& c : scene.classes)
        for (const Measurement& m : c.measurements)
            if (c.name == rays && m.name == name && m.mode == mode) return &m;
    return nullptr;
}

std::vector<std::string> summary_cells(const SceneResult& scene) {
    std::vector<std::string> cells{scene.name, std::to_string(scene.faces)};
    for (const char* rays : {"primary", "mirrored", "random", "grazing"}) {
        const Measurement* m = find(scene, rays, "Keiko", Mode::packets);
        cells.push_back(m != nullptr ? digits(m->rate / 1e6) : "");
    }
    const Measurement* other = find(scene, "primary", "OpenCASCADE", Mode::single);
    cells.push_back(other != nullptr ? digits(other->keiko_packets) : "");
    for (const char* mesh : {"mesh 0.1 mm", "mesh 0.01 mm"}) {
        const Measurement* m = find(scene, "primary", mesh, Mode::packets);
        const bool shown = m != nullptr && m->accuracy && m->accuracy->zebra;
        cells.push_back(shown ? digits(m->ratio()) + ", " + digits(m->accuracy->zebra->p999) : "");
    }
    return cells;
}

} // namespace

Table cost_table(const SceneResult& scene) {
    Table table{
        .head = {"contender", "elements", "off by mm", "mesh s", "build s", "MB", "remark"}};
    for (const ContenderFacts& c : scene.contenders) {
        if (c.elements == 0) continue;
        table.rows.push_back(
            {c.name, std::to_string(c.elements), c.deviation > 0 ? digits(c.deviation) : "",
             c.mesh_seconds > 0 ? digits(c.mesh_seconds) : "", digits(c.build_seconds),
             c.bytes > 0 ? digits(static_cast<double>(c.bytes) / 1e6) : "–", c.remark});
    }
    return table;
}

Table rate_table(const SceneResult& scene) {
    Table table{
        .head = {"rays", "contender", "mode", "Mrays/s", "Keiko ×", "t, uv ×", "missed", "false",
                 "normal ″ p50 / p99", "lateral mm p99", "zebra px p50 / p99 / p99.9"},
        .left = 3};
    for (const ClassResult& rays : scene.classes)
        for (const Measurement& m : rays.measurements)
            table.rows.push_back(rate_cells(&m == &rays.measurements.front() ? rays.name : "", m));
    return table;
}

Table summary_table(const TraceResults& results) {
    Table table{.head = {"scene", "faces", "primary", "mirrored", "random", "grazing",
                         "× OpenCASCADE", "× mesh 0.1 mm, px p99.9", "× mesh 0.01 mm, px p99.9"}};
    for (const SceneResult& scene : results.scenes) table.rows.push_back(summary_cells(scene));
    return table;
}

std::string title_of(const SceneResult& scene) {
    return scene.name + ": " + std::to_string(scene.faces) + " faces, " +
           std::to_string(scene.patches) + " patches, " + digits(scene.size) + " mm";
}

std::string conditions_of(const TraceResults& results) {
    const Machine& m = results.machine;
    return m.cpu + " (" + m.simd + "), one thread; " + m.compiler + "; " + m.date + "; " +
           std::to_string(results.rays) + " rays a class, medians of " +
           std::to_string(results.rounds) + " interleaved rounds";
}

} // namespace keiko::bench
