#include "tests/bench/results_json.h"

#include "keiko/base/error.h"

#include "tests/bench/targets.h"
#include <nlohmann/json.hpp>

#include <fstream>

namespace keiko::bench {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Kind kind) {
    switch (kind) {
        case Kind::keiko:
            return "keiko";
        case Kind::crossings:
            return "keiko-crossings";
        case Kind::opencascade:
            return "opencascade";
        case Kind::mesh:
            return "mesh";
        case Kind::grid:
            return "grid";
        case Kind::traversal:
            return "empty-callback";
        case Kind::traversal_to_hit:
            return "empty-callback-to-hit";
    }
    return "";
}

Json json_of(const Accuracy& a) {
    Json json{{"rays", a.rays},
              {"hits", a.hits},
              {"missed", a.missed},
              {"false", a.false_hits},
              {"normal_arcsec", {{"p50", a.normal_p50}, {"p99", a.normal_p99}}},
              {"lateral_mm", {{"p99", a.lateral_p99}}}};
    if (a.zebra)
        json["zebra_px"] = {{"p50", a.zebra->p50}, {"p99", a.zebra->p99}, {"p99.9", a.zebra->p999}};
    return json;
}

Json json_of(const Measurement& m) {
    Json json{{"kind", name_of(m.kind)},
              {"contender", m.name},
              {"mode", bench::name_of(m.mode)},
              {"rays_per_second", m.rate},
              {"keiko_single_ratio", m.keiko_single},
              {"keiko_packets_ratio", m.keiko_packets},
              {"keiko_crossings_ratio", m.crossings}};
    if (m.accuracy) json["accuracy"] = json_of(*m.accuracy);
    return json;
}

Json json_of(const ContenderFacts& c) {
    return {{"kind", name_of(c.kind)},
            {"contender", c.name},
            {"deflection_mm", c.deflection},
            {"deviation_mm", c.deviation},
            {"elements", c.elements},
            {"bytes", c.bytes},
            {"mesh_seconds", c.mesh_seconds},
            {"build_seconds", c.build_seconds},
            {"remark", c.remark}};
}

Json json_of(const KernelCosts& costs, Mode mode) {
    return {{"mode", name_of(mode)},
            {"look_cycles", costs.look},
            {"solve_cycles", costs.solve},
            {"proof_share", costs.proof}};
}

Json json_of(const ClassResult& c) {
    Json json{{"class", c.name}, {"rays", c.rays}, {"hits", c.hits}, {"tangential", c.tangential}};
    for (const Mode mode : {Mode::single, Mode::packets})
        json["kernel_costs"].push_back(json_of(c.costs[static_cast<std::size_t>(mode)], mode));
    for (const Measurement& m : c.measurements) json["measurements"].push_back(json_of(m));
    return json;
}

Json json_of(const SceneResult& scene) {
    Json json{{"scene", scene.name},
              {"faces", scene.faces},
              {"patches", scene.patches},
              {"size_mm", scene.size}};
    for (const ContenderFacts& c : scene.contenders) json["contenders"].push_back(json_of(c));
    for (const ClassResult& c : scene.classes) json["classes"].push_back(json_of(c));
    return json;
}

Json json_of(const Table& table) {
    Json json = Json::array();
    for (const auto& row : table.rows) {
        Json line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line[table.head[i].empty() ? "verdict" : table.head[i]] = row[i];
        json.push_back(line);
    }
    return json;
}

} // namespace

void write_json(const std::filesystem::path& file, const TraceResults& results) {
    const Machine& m = results.machine;
    Json json{
        {"format", "keiko-bench-trace/1"},
        {"machine", {{"cpu", m.cpu}, {"simd", m.simd}, {"compiler", m.compiler}, {"date", m.date}}},
        {"rays", results.rays},
        {"rounds", results.rounds},
        {"trimming_cost", results.trimming_cost},
        {"targets", json_of(target_table(results))},
        {"skipped", results.skipped}};
    for (const SceneResult& scene : results.scenes) json["scenes"].push_back(json_of(scene));
    std::ofstream out(file);
    out << json.dump(1) << "\n";
    if (!out.flush()) throw Error(file.string(), "", "cannot be written");
}

} // namespace keiko::bench
