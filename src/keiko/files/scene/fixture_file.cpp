#include "keiko/files/scene/fixture_file.h"

#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/material_file.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/files/scene/zone_table.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/scene/view.h"

#include <algorithm>

namespace keiko {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view fixture_format = "keiko-fixture/1";
constexpr double largest_size = 4096; ///< pixels, either way
constexpr TomlLimits joins{.low = 0, .high = 1000, .above_low = true};

/// One text, or an array of some.
std::vector<std::string> one_or_more(const TomlTable& table, std::string_view key) {
    if (table.kind(key) == "text") return {*table.text(key)};
    auto texts = table.required(key, table.texts(key));
    if (texts.empty()) throw table.error(key, "must name at least one");
    return texts;
}

/// Throws Error at `key` unless `word` is one of `known`.
void require_known(const TomlTable& table, std::string_view key, const std::string& word,
                   const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), word) != known.end()) return;
    throw table.error(key, "unknown '" + shortened(word) + "'" + did_you_mean(word, known) +
                               "; there are " + comma_list(known));
}

void require_each_once(const TomlTable& table, std::string_view key,
                       std::vector<std::string> words) {
    std::sort(words.begin(), words.end());
    const auto twice = std::adjacent_find(words.begin(), words.end());
    if (twice != words.end()) throw table.error(key, "names '" + shortened(*twice) + "' twice");
}

std::vector<std::string> words_of(const TomlTable& table, std::string_view key,
                                  const std::vector<std::string>& known) {
    std::vector<std::string> words = table.texts(key).value_or(std::vector<std::string>{});
    for (const std::string& word : words) require_known(table, key, word, known);
    require_each_once(table, key, words);
    return words;
}

void read_body(const TomlTable& root, FixtureSpec& fixture) {
    if (const auto scene = root.text("scene")) {
        for (const char* key : {"model", "material"})
            if (root.has(key)) throw root.error(key, "stands in the scene where there is one");
        fixture.models = {readable_path(root, "scene", *scene)};
        if (fixture.models.front().extension() != ".toml")
            throw root.error("scene", "is no .toml file; a model file is named by 'model'");
        return;
    }
    for (const std::string& model : one_or_more(root, "model"))
        fixture.models.push_back(readable_path(root, "model", model));
    fixture.material = root.text("material");
    if (!fixture.material) return;
    try {
        named_material(*fixture.material);
    } catch (const Error& error) {
        throw root.error("material", error.reason());
    }
}

CriteriaPreset preset_from(const TomlTable& root) {
    const auto name = root.text("preset");
    if (!name) return standard_presets().front();
    if (fs::path(*name).extension() == ".toml")
        return read_preset(readable_path(root, "preset", *name));
    try {
        return preset_by_name(*name);
    } catch (const Error& error) {
        throw root.error("preset", error.reason());
    }
}

/// Puts the zones of the fixture before those of its preset.
void read_zones(const TomlTable& root, CriteriaPreset& preset) {
    std::vector<Zone> zones = zones_from(root, preset);
    for (const Zone& zone : preset.zones) {
        if (std::any_of(zones.begin(), zones.end(),
                        [&](const Zone& own) { return own.name == zone.name; }))
            throw root.error("zone", "'" + shortened(zone.name) + "' is a zone of the preset, too");
        zones.push_back(zone);
    }
    preset.zones = std::move(zones);
}

/// "auto" would choose another view after the change that it should show.
void read_views(const TomlTable& root, FixtureSpec& fixture) {
    std::vector<std::string> known = view_names();
    known.emplace_back("scene");
    fixture.views = words_of(root, "views", known);
    const auto size = root.numbers("size", 2, {.low = 1, .high = largest_size});
    if (!size) return;
    for (const double edge : *size)
        if (edge != static_cast<int>(edge)) throw root.error("size", "must be whole numbers");
    fixture.width = static_cast<int>((*size)[0]), fixture.height = static_cast<int>((*size)[1]);
}

FixtureChecks checks_from(const TomlTable& root) {
    static const std::vector<std::string> known{"shape", "seams", "lines", "pictures"};
    if (!root.has("checks")) return {};
    const std::vector<std::string> words = words_of(root, "checks", known);
    if (words.empty()) throw root.error("checks", "must name at least one");
    const auto among = [&](const char* word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    return {among("shape"), among("seams"), among("lines"), among("pictures")};
}

LayerTolerance layer_from(const TomlTable& table, LayerTolerance tolerance) {
    const TomlLimits limits = TomlLimits::not_negative();
    tolerance.absolute = table.number("absolute", limits).value_or(tolerance.absolute);
    tolerance.relative = table.number("relative", TomlLimits::share()).value_or(tolerance.relative);
    tolerance.allowed = table.number("allowed", TomlLimits::share()).value_or(tolerance.allowed);
    tolerance.hard = table.number("hard", {.low = 1}).value_or(tolerance.hard);
    table.finish();
    return tolerance;
}

void read_film_tolerance(const TomlTable& table, FilmTolerance& tolerance) {
    const auto take = [&](const char* name, LayerTolerance& layer) {
        if (const auto given = table.table(name)) layer = layer_from(*given, layer);
    };
    take("color", tolerance.color);
    take("normal", tolerance.normal);
    take("depth", tolerance.depth);
    take("uv", tolerance.uv);
    take("c_plane_uv", tolerance.c_plane_uv);
    tolerance.flips = table.number("flips", TomlLimits::share()).value_or(tolerance.flips);
    table.finish();
}

/// A number is the absolute tolerance; a table may hold both.
MetricTolerance metric_tolerance_from(const TomlTable& table, std::string_view key,
                                      MetricTolerance tolerance) {
    if (table.kind(key) != "table") return {*table.number(key, TomlLimits::not_negative()), 0};
    const TomlTable both = *table.table(key);
    tolerance.absolute =
        both.number("absolute", TomlLimits::not_negative()).value_or(tolerance.absolute);
    tolerance.relative = both.number("relative", TomlLimits::share()).value_or(tolerance.relative);
    both.finish();
    return tolerance;
}

void read_metric_tolerances(const TomlTable& table, MetricTolerances& tolerances) {
    for (std::size_t i = 0; i < quantity_count; ++i) {
        const auto quantity = static_cast<Quantity>(i);
        if (quantity == Quantity::verdict || !table.has(name_of(quantity))) continue;
        tolerances[quantity] =
            metric_tolerance_from(table, name_of(quantity), tolerances[quantity]);
    }
    table.finish();
}

/// Whether a file states another format of Keiko. One that cannot be read may be a fixture.
bool is_of_another_format(const fs::path& file) {
    try {
        const TomlTable root = TomlTable::read(file);
        if (root.kind("format") != "text") return false;
        const std::string format = *root.text("format");
        return format.starts_with("keiko-") && !format.starts_with("keiko-fixture/");
    } catch (const Error&) {
        return false;
    }
}

/// Whether a file is hidden, as those that editors and file managers leave beside a file.
bool is_hidden(const fs::path& file) {
    return file.filename().string().starts_with(".");
}

/// The output folder holds a folder of the fixture's name beside these.
void require_usable_name(const FixtureFile& fixture) {
    for (const char* taken : {"regression.json", "junit.xml", "index.html"})
        if (fixture.name == taken)
            throw Error(fixture.file.string(), "",
                        "is called as a file that keiko regress writes; rename it");
}

} // namespace

FixtureSpec parse_fixture(std::string_view text, const std::string& source) {
    const TomlTable root = TomlTable::parse(text, source);
    root.require_format(fixture_format);
    FixtureSpec fixture;
    fixture.file = source;
    fixture.name = fixture.file.stem().string();
    read_body(root, fixture);
    read_views(root, fixture);
    if (const auto rig = root.text("rig")) fixture.rig = readable_path(root, "rig", *rig);
    fixture.preset = preset_from(root);
    read_zones(root, fixture.preset);
    fixture.join = root.number("join", joins).value_or(fixture.join);
    fixture.layers = words_of(root, "layers", fixture_layers);
    fixture.shadows = root.flag("shadows").value_or(false);
    fixture.checks = checks_from(root);
    if (const auto table = root.table("tolerance"))
        read_metric_tolerances(*table, fixture.metric_tolerance);
    if (const auto table = root.table("picture_tolerance"))
        read_film_tolerance(*table, fixture.film_tolerance);
    root.finish();
    return fixture;
}

FixtureSpec read_fixture(const fs::path& path) {
    return parse_fixture(read_text_file(path), path.string());
}

std::vector<FixtureFile> fixture_files(const fs::path& folder) {
    std::error_code code;
    fs::directory_iterator files(folder, code);
    if (code) throw Error(folder.string(), "", "cannot read the folder: " + code.message());
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : files)
        if (entry.path().extension() == ".toml" && !is_hidden(entry.path()))
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end(),
              [](const fs::path& a, const fs::path& b) { return a.stem() < b.stem(); });
    std::vector<FixtureFile> fixtures;
    for (const fs::path& path : paths)
        if (!is_of_another_format(path)) {
            fixtures.push_back({path.stem().string(), path});
            require_usable_name(fixtures.back());
        }
    if (fixtures.empty())
        throw Error(folder.string(), "",
                    "holds no fixture: no .toml file with format = \"" +
                        std::string(fixture_format) + "\"");
    return fixtures;
}

} // namespace keiko
