#include "tests/bench/targets.h"

#include "tests/bench/summary.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace keiko::bench {
namespace {

using SceneFilter = std::function<bool(const SceneResult&)>;

bool any_scene(const SceneResult&) {
    return true;
}
bool free_form(const SceneResult& scene) {
    return scene.free_form;
}
SceneFilter named(std::string name) {
    return [name = std::move(name)](const SceneResult& scene) { return scene.name == name; };
}

const ContenderFacts* facts_of(const SceneResult& scene, const Measurement& m) {
    for (const ContenderFacts& c : scene.contenders)
        if (c.kind == m.kind && c.name == m.name) return &c;
    return nullptr;
}

/// Least and greatest deflection stand for the coarse and the fine mesh; null without meshes.
const ContenderFacts* mesh(const SceneResult& scene, bool fine) {
    const ContenderFacts* best = nullptr;
    for (const ContenderFacts& c : scene.contenders)
        if (c.kind == Kind::mesh && (!best || (c.deflection < best->deflection) == fine)) best = &c;
    return best;
}

const ContenderFacts& keiko(const SceneResult& scene) {
    return *std::find_if(scene.contenders.begin(), scene.contenders.end(),
                         [](const ContenderFacts& c) { return c.kind == Kind::keiko; });
}

class TargetTable {
public:
    explicit TargetTable(const TraceResults& results) : results_(results) {
        table_.head = {"against", "target", "median", "least", "most", "scenes", ""};
        table_.left = 1;
    }

    /// A row of measurements: those of the scenes and the class for which `value` is a number.
    void row(const std::string& what, double target, const SceneFilter& scenes,
             const std::string& rays,
             const std::function<double(const SceneResult&, const Measurement&)>& value) {
        std::vector<double> values;
        for (const SceneResult& scene : results_.scenes) {
            if (!scenes(scene)) continue;
            for (const ClassResult& c : scene.classes)
                for (const Measurement& m : c.measurements)
                    if (const double x = value(scene, m);
                        (rays.empty() || c.name == rays) && x == x)
                        values.push_back(x);
        }
        add(what + (rays.empty() ? "" : ", " + rays), target, std::move(values));
    }

    /// A row with one value a scene: those for which it is a number.
    void scene_row(const std::string& what, double target, const SceneFilter& scenes,
                   const std::function<double(const SceneResult&)>& value) {
        std::vector<double> values;
        for (const SceneResult& scene : results_.scenes)
            if (scenes(scene))
                if (const double x = value(scene); x == x) values.push_back(x);
        add(what, target, std::move(values));
    }

    /// A row with one value a scene, of one class of rays, that is to stay below; NaN: no target.
    void class_row(const std::string& what, double most, const std::string& rays,
                   const std::function<double(const ClassResult&)>& value) {
        std::vector<double> values;
        for (const SceneResult& scene : results_.scenes)
            for (const ClassResult& c : scene.classes)
                if (c.name == rays) values.push_back(value(c));
        add_below(what + ", " + rays, most, std::move(values));
    }

    /// A row of words.
    void note(const std::string& what, const std::string& target, const std::string& measured,
              const std::string& verdict) {
        table_.rows.push_back({what, target, measured, "", "", "", verdict});
    }

    Table finish() { return std::move(table_); }

private:
    void add(const std::string& what, double target, std::vector<double> values) {
        if (values.empty()) return note(what, "≥ " + digits(target), "–", "not run");
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        const std::string verdict = *least >= target ? "met" : *most >= target ? "in part" : "no";
        table_.rows.push_back({what, "≥ " + digits(target), digits(median(values)), digits(*least),
                               digits(*most), std::to_string(values.size()), verdict});
    }

    void add_below(const std::string& what, double target, std::vector<double> values) {
        const std::string wanted = target == target ? "≤ " + digits(target) : "";
        if (values.empty()) return note(what, wanted, "–", "not run");
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        const std::string verdict = wanted.empty()     ? ""
                                    : *most <= target  ? "met"
                                    : *least <= target ? "in part"
                                                       : "no";
        table_.rows.push_back({what, wanted, digits(median(values)), digits(*least), digits(*most),
                               std::to_string(values.size()), verdict});
    }

    const TraceResults& results_;
    Table table_;
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Keiko's hits that a row compares: whole hits, or t and uv only as a triangle's hit is.
using Ratio = double (*)(const Measurement&);
double whole_hits(const Measurement& m) {
    return m.ratio();
}
double crossings(const Measurement& m) {
    return m.crossings;
}

auto ratio_to(Kind kind, Mode mode, Ratio ratio = whole_hits) {
    return [=](const SceneResult&, const Measurement& m) {
        return m.kind == kind && m.mode == mode ? ratio(m) : none;
    };
}

auto ratio_to_mesh(bool fine, Mode mode, Ratio ratio) {
    return [=](const SceneResult& scene, const Measurement& m) {
        return m.kind == Kind::mesh && m.mode == mode && m.name == mesh(scene, fine)->name
                   ? ratio(m)
                   : none;
    };
}

auto ratio_to_exact_grid(Ratio ratio) {
    return [=](const SceneResult& scene, const Measurement& m) {
        return m.kind == Kind::grid && m.mode == Mode::packets && facts_of(scene, m)->exact_enough
                   ? ratio(m)
                   : none;
    };
}

auto rate_of_keiko(Mode mode) {
    return [=](const SceneResult&, const Measurement& m) {
        return m.kind == Kind::keiko && m.mode == mode ? m.rate / 1e6 : none;
    };
}

double packets_against_opencascade(const SceneResult&, const Measurement& m) {
    return m.kind == Kind::opencascade ? m.keiko_packets : none;
}

void add_traversal(TargetTable& table, const std::string& what, Ratio ratio) {
    for (const char* rays : {"primary", "mirrored", "random"})
        table.row(what + "share of the empty callback's rate, single", 0.55, any_scene, rays,
                  ratio_to(Kind::traversal, Mode::single, ratio));
    for (const char* rays : {"primary", "mirrored", "random"})
        table.row(what + "share of the empty callback's rate, packets", 0.6, any_scene, rays,
                  ratio_to(Kind::traversal, Mode::packets, ratio));
}

void add_opencascade(TargetTable& table) {
    const std::string what = "OpenCASCADE, free-form";
    const auto single = ratio_to(Kind::opencascade, Mode::single);
    table.row(what + ", single", 1300, free_form, "primary", single);
    table.row(what + ", single", 1500, free_form, "mirrored", single);
    table.row(what + ", single", 1000, free_form, "random", single);
    for (const char* rays : {"primary", "mirrored"})
        table.row(what + ", packets", 4000, free_form, rays, packets_against_opencascade);
    for (const char* rays : {"primary", "mirrored", "random"})
        table.row("OpenCASCADE, linkrods, single", 2000, named("linkrods"), rays, single);
    table.row("OpenCASCADE, single", 100, any_scene, "grazing", single);
}

void add_meshes(TargetTable& table, const std::string& what, Ratio ratio) {
    // Only there does BRepMesh make as many triangles as the design has in mind.
    const SceneFilter car = named("concept-car");
    const auto single = ratio_to_mesh(true, Mode::single, ratio);
    const auto packets = ratio_to_mesh(true, Mode::packets, ratio);
    const std::string fine = what + "finest mesh run, concept-car";
    table.row(fine + ", single", 3, car, "primary", single);
    table.row(fine + ", single", 4.5, car, "mirrored", single);
    table.row(fine + ", single", 7, car, "random", single);
    table.row(fine + ", packets", 6, car, "primary", packets);
    table.row(fine + ", packets", 10, car, "mirrored", packets);
    for (const Mode mode : {Mode::single, Mode::packets})
        for (const char* rays : {"primary", "mirrored", "random"})
            table.row(what + "mesh 1 mm, " + name_of(mode), 1, any_scene, rays,
                      ratio_to_mesh(false, mode, ratio));
    for (const char* rays : {"primary", "mirrored"})
        table.row(what + "grid per span at 0.1 px, packets", 1.5, any_scene, rays,
                  ratio_to_exact_grid(ratio));
}

void add_costs(TargetTable& table) {
    const SceneFilter car = named("concept-car");
    table.scene_row(
        "memory, finest mesh run / Keiko, concept-car", 1000, car, [](const SceneResult& scene) {
            const ContenderFacts* fine = mesh(scene, true);
            return fine ? static_cast<double>(fine->bytes) / static_cast<double>(keiko(scene).bytes)
                        : none;
        });
    table.scene_row("load time, finest mesh run / Keiko, concept-car", 10000, car,
                    [](const SceneResult& scene) {
                        const ContenderFacts* fine = mesh(scene, true);
                        return fine ? (fine->mesh_seconds + fine->build_seconds) /
                                          keiko(scene).build_seconds
                                    : none;
                    });
}

void add_rates(TargetTable& table) {
    for (const char* rays : {"primary", "mirrored"})
        table.row("Mrays/s, packets", 30, any_scene, rays, rate_of_keiko(Mode::packets));
    table.row("Mrays/s, packets", 6.5, any_scene, "random", rate_of_keiko(Mode::packets));
    table.row("Mrays/s, packets", 0.5, any_scene, "grazing", rate_of_keiko(Mode::packets));
}

void add_kernels(TargetTable& table, const TraceResults& results) {
    for (const Mode mode : {Mode::single, Mode::packets})
        for (const char* rays : {"primary", "mirrored", "random"}) {
            const auto costs = [&](double KernelCosts::*what) {
                return [=](const ClassResult& c) {
                    return c.costs[static_cast<std::size_t>(mode)].*what;
                };
            };
            const std::string how = std::string(", ") + name_of(mode);
            table.class_row("cycles a ray–patch test: first look" + how, 35, rays,
                            costs(&KernelCosts::look));
            table.class_row("cycles a root with its bound" + how, none, rays,
                            costs(&KernelCosts::solve));
            table.class_row("cost of the proof" + how, 0.1, rays, costs(&KernelCosts::proof));
        }
    table.note("cost of trimming, 100 curves a face, packets", "≤ 0.05",
               digits(results.trimming_cost), results.trimming_cost <= 0.05 ? "met" : "no");
}

void add_losses(TargetTable& table, const TraceResults& results) {
    std::size_t built = 0, lost = 0, undecided = 0;
    for (const SceneResult& scene : results.scenes)
        for (const ClassResult& c : scene.classes) {
            if (c.name != "grazing") continue;
            const Measurement& keiko = c.measurements.front();
            built += keiko.accuracy->hits;
            lost += keiko.accuracy->missed;
            undecided += c.tangential;
        }
    table.note("hits lost of grazing rays through known points", "0",
               std::to_string(lost) + " of " + std::to_string(built), lost == 0 ? "met" : "no");
    table.note("of the same, flagged tangential", "≤ 1e-6", share(undecided, built),
               static_cast<double>(undecided) <= 1e-6 * static_cast<double>(built) ? "met" : "no");
}

} // namespace

Table target_table(const TraceResults& results) {
    TargetTable table(results);
    add_traversal(table, "", whole_hits);
    add_traversal(table, "t, uv: ", crossings);
    add_opencascade(table);
    add_meshes(table, "", whole_hits);
    add_meshes(table, "t, uv: ", crossings);
    add_costs(table);
    add_rates(table);
    add_kernels(table, results);
    add_losses(table, results);
    return table.finish();
}

} // namespace keiko::bench
