#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/job.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keiko {
namespace {

constexpr int most_nodes = 1024;
constexpr double largest = 1e9; ///< mm, and times the extinction

/// Words between blanks and line ends, with what follows a # skipped.
class Words {
public:
    Words(std::string_view text, const std::string& source) : rest_(text), source_(source) {}

    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(source_, std::to_string(line_), reason);
    }
    std::string_view next() {
        skip();
        const std::size_t end = std::min(rest_.find_first_of(" \t\r\n#"), rest_.size());
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }
    void expect(std::string_view word) {
        const std::string_view found = next();
        if (found != word) fail("expected '" + std::string(word) + "', found " + in_quotes(found));
    }
    double number() {
        const std::string_view word = next();
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty()) fail("ends too early");
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            fail(in_quotes(word) + " is not a number");
        if (std::abs(value) > largest) fail(in_quotes(word) + " is beyond 1e9");
        return value;
    }
    bool at_end() {
        skip();
        return rest_.empty();
    }

private:
    void skip() {
        while (!rest_.empty()) {
            const char c = rest_.front();
            if (c == '#') {
                rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
            } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
                line_ += c == '\n' ? 1 : 0;
                rest_.remove_prefix(1);
            } else {
                return;
            }
        }
    }

    std::string_view rest_;
    const std::string& source_;
    std::size_t line_ = 1;
};

Vec3 vector_in(Words& words) {
    const double x = words.number(), y = words.number();
    return {x, y, words.number()};
}

int nodes_in(Words& words) {
    const double count = words.number();
    if (!(count >= 2 && count <= most_nodes && count == std::floor(count)))
        words.fail("nodes must be whole numbers from 2 to " + std::to_string(most_nodes));
    return static_cast<int>(count);
}

constexpr double most_k = 1e6, most_g = 0.999;
/// 1/m; of the largest a micrometre is thick.
constexpr TomlLimits extinctions{.low = 0, .high = 1e6};
constexpr std::size_t most_waves = 64;
/// mm: a ray that meets nothing ends after 1e6 mm, on which it meets every wave.
constexpr double shortest_wave = 20;
/// mm: the shortest of its waves are a fourteenth as long.
constexpr double shortest_noise = 300;
constexpr double longest_wave = TomlLimits::length().high;
/// mm: higher ones are no height of a layer, and their slopes leave double precision.
constexpr double highest_wave = 1e6;
/// Largest amplitude as a share of the wavelength: through higher waves every ray has too many
/// crossings.
constexpr double most_steepness = 0.25;

double highest_of(double wavelength) {
    return std::min(highest_wave, most_steepness * wavelength);
}

} // namespace

PhaseFunction phase_from(const TomlTable& table) {
    const std::size_t kind =
        table.required("kind", table.choice("kind", {"isotropic", "fog", "henyey-greenstein"}));
    const auto k = table.number("k", {.low = 0, .high = most_k});
    const auto g = table.number("g", {.low = -most_g, .high = most_g});
    if (kind != 1 && k) throw table.error("k", "belongs to kind = \"fog\" alone");
    if (kind != 2 && g) throw table.error("g", "belongs to kind = \"henyey-greenstein\" alone");
    table.finish();
    if (kind == 2) return HenyeyGreenstein{table.required("g", g)};
    return HazePhase{kind == 1 ? table.required("k", k) : 0};
}

namespace {

Vec2 pair_from(const std::vector<double>& numbers) {
    return {numbers[0], numbers[1]};
}

Wave wave_from(const TomlTable& table) {
    Wave wave;
    wave.wavelength = pair_from(table.required(
        "wavelength",
        table.numbers("wavelength", 2, {.low = shortest_wave, .high = longest_wave})));
    const double highest = highest_of(std::min(wave.wavelength.x, wave.wavelength.y));
    wave.amplitude =
        table.required("amplitude", table.number("amplitude", {.low = -highest, .high = highest}));
    if (const auto phase = table.numbers("phase", 2, {.low = -1e6, .high = 1e6}))
        wave.phase = pair_from(*phase);
    table.finish();
    return wave;
}

std::vector<Wave> noise_from(const TomlTable& table) {
    const double wavelength = table.required(
        "wavelength", table.number("wavelength", {.low = shortest_noise, .high = longest_wave}));
    return noise_waves(
        table.required("amplitude",
                       table.number("amplitude", {.low = 0, .high = highest_of(wavelength)})),
        wavelength);
}

std::vector<Wave> waves_from(const TomlTable& table) {
    const auto bump = table.choice("bump", {"none", "noise", "waves"}).value_or(0);
    if (bump == 1) return noise_from(table);
    for (const std::string_view key : {"amplitude", "wavelength"})
        if (table.has(key)) throw table.error(key, "belongs to bump = \"noise\" alone");
    std::vector<Wave> waves;
    for (const TomlTable& wave : table.tables("waves")) waves.push_back(wave_from(wave));
    if (bump == 0 && !waves.empty()) throw table.error("waves", "belong to bump = \"waves\"");
    if (bump == 2 && waves.empty()) table.refuse_misspelt();
    if (bump == 2 && (waves.empty() || waves.size() > most_waves))
        throw table.error("waves", "must be 1 to " + std::to_string(most_waves) + " tables");
    return waves;
}

LayeredDensity layer_from(const TomlTable& table) {
    LayeredDensity layers;
    layers.border.height = table.required("height", table.number("height", TomlLimits::place()));
    layers.extinction_above =
        table.required("extinction_above", table.rgb("extinction_above", extinctions));
    layers.border.waves = waves_from(table);
    table.finish();
    return layers;
}

Density density_from(const TomlTable& table) {
    const auto layer = table.table("layer");
    const auto file = path_from(table, "density");
    if (layer && file) throw table.error("density", "give either layer or density, not both");
    if (layer) return layer_from(*layer);
    if (file)
        return GridDensity{std::make_shared<const VoxelDensity>(read_density(*file)),
                           file->string()};
    return HomogeneousDensity{};
}

std::string text_of(const Vec2& pair) {
    return toml_value(std::array{pair.x, pair.y});
}

std::string text_of(const Wave& wave) {
    return "{ amplitude = " + toml_value(wave.amplitude) +
           ", wavelength = " + text_of(wave.wavelength) + ", phase = " + text_of(wave.phase) + " }";
}

std::string text_of(const LayeredDensity& layers) {
    std::string text = "{ height = " + toml_value(layers.border.height) +
                       ", extinction_above = " + toml_value(layers.extinction_above);
    if (!layers.border.waves.empty()) {
        text += ", bump = \"waves\", waves = [";
        for (const Wave& wave : layers.border.waves)
            text += (text.back() == '[' ? " " : ", ") + text_of(wave);
        text += " ]";
    }
    return text + " }";
}

std::string text_of(const PhaseFunction& phase) {
    if (const auto* lobe = std::get_if<HenyeyGreenstein>(&phase))
        return "{ kind = \"henyey-greenstein\", g = " + toml_value(lobe->g) + " }";
    return "{ kind = \"fog\", k = " + toml_value(std::get<HazePhase>(phase).k) + " }";
}

} // namespace

VoxelDensity parse_density(std::string_view text, const std::string& source) {
    Words words(text, source);
    words.expect("keiko-density/1");
    words.expect("nodes");
    std::array<int, 3> nodes{};
    for (int& count : nodes) count = nodes_in(words);
    words.expect("low");
    const Vec3 low = vector_in(words);
    words.expect("high");
    const Vec3 high = vector_in(words);
    for (unsigned axis = 0; axis < 3; ++axis)
        if (!(low[axis] < high[axis])) words.fail("low must be below high");
    words.expect("values");
    const auto count = static_cast<std::size_t>(nodes[0]) * static_cast<std::size_t>(nodes[1]) *
                       static_cast<std::size_t>(nodes[2]);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        check_stop();
        values.push_back(words.number());
        if (values.back() < 0) words.fail("a density must not be negative");
    }
    if (!words.at_end()) words.fail("has more values than nodes");
    return {low, high, nodes, std::move(values)};
}

VoxelDensity read_density(const std::filesystem::path& path) {
    return parse_density(read_text_file(path), path.string());
}

Medium medium_from(const TomlTable& table) {
    Medium medium;
    medium.extinction = table.required("extinction", table.rgb("extinction", extinctions));
    medium.albedo = table.rgb("albedo", TomlLimits::share()).value_or(medium.albedo);
    medium.ambient = table.rgb("ambient", TomlLimits::light()).value_or(medium.ambient);
    if (const auto phase = table.table("phase")) medium.phase = phase_from(*phase);
    medium.density = density_from(table);
    if (const auto leg = table.choice("light_leg", {"dimmed", "clear"}))
        medium.dims_light_leg = *leg == 0;
    if (table.choice("fidelity", {"paper", "corrected"}) == 0)
        medium.rule = ScatteringRule::simpson;
    table.finish();
    return medium;
}

std::string table_text(const Medium& medium, const std::filesystem::path& folder) {
    std::string text = "\n[fog]\n";
    text += toml_line("extinction", toml_value(medium.extinction), "1/m");
    text += toml_line("albedo", toml_value(medium.albedo));
    text += toml_line("ambient", toml_value(medium.ambient), "cd/m2");
    if (medium.phase != PhaseFunction()) text += toml_line("phase", text_of(medium.phase));
    if (const auto* layers = std::get_if<LayeredDensity>(&medium.density))
        text += toml_line("layer", text_of(*layers));
    if (const auto* grid = std::get_if<GridDensity>(&medium.density))
        text += toml_line("density", toml_string(named_from(folder, grid->file)));
    if (!medium.dims_light_leg) text += toml_line("light_leg", "\"clear\"");
    if (medium.rule == ScatteringRule::simpson) text += toml_line("fidelity", "\"paper\"");
    return text;
}

} // namespace keiko
