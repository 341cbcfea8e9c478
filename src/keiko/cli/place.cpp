#include "keiko/api/place.h"

#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/cli/inspection_options.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"

#include <array>
#include <cstdio>
#include <map>
#include <memory>

namespace keiko::cli {
namespace {

const std::map<std::string, Vec3> named_planes{{"above", {0, 0, 1}},
                                               {"front", {-1, 0, 0}},
                                               {"left", {0, -1, 0}},
                                               {"rear", {1, 0, 0}},
                                               {"right", {0, 1, 0}}};

struct PlaceArguments {
    SceneArguments scene;
    PlaceOptions options;
    std::string direction = "auto", kind = "tube", stripes;
    std::vector<std::string> planes;
    bool pixels = false, each = false;
    std::filesystem::path output, report, rated, hits;
    SymmetryOption symmetry;
};

/// Requires the ending of a rig: a file of any other name may be the model, which would be
/// overwritten.
void require_rig_extension(const std::filesystem::path& path) {
    if (path.extension() != ".toml")
        throw Error(path.string(), "", "a rig is written as a file that ends in .toml");
}

StripeSpacing parse_stripes(const std::string& text) {
    StripeSpacing s;
    int end = 0;
    if (std::sscanf(text.c_str(), "%lf:%lf%n", &s.least, &s.most, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || !(s.least > 0) || !(s.most > s.least) ||
        !(s.most < 1e6))
        throw Error("", "--stripes", "'" + text + "' is not LEAST:MOST pixels, 0 < LEAST < MOST");
    s.wanted = std::sqrt(s.least * s.most);
    return s;
}

PlaneChoice parse_planes(std::span<const std::string> names) {
    PlaneChoice choice;
    for (const std::string& name : names) {
        if (const auto known = named_planes.find(name); known != named_planes.end()) {
            choice.towards.push_back(known->second);
            continue;
        }
        if (std::filesystem::path(name).extension() != ".toml")
            throw Error("", "--plane",
                        "'" + name + "' is neither above, front, left, rear, right nor a rig file");
        for (const LightSource& source : read_rig(name).sources)
            if (const auto* plane = std::get_if<CPlane>(&source))
                choice.frames.push_back(frame_of(*plane));
    }
    return choice;
}

PlaceOptions placing(const PlaceArguments& arguments) {
    PlaceOptions options = arguments.options;
    PlacementOptions& placement = options.placement;
    options.symmetry = arguments.symmetry.choice();
    if (!arguments.stripes.empty()) placement.spacing = parse_stripes(arguments.stripes);
    placement.where = parse_planes(arguments.planes);
    if (arguments.direction == "along") placement.direction = LampDirection::along;
    for (const LampKind kind : lamp_kinds)
        if (name_of(kind) == arguments.kind) placement.kind = kind;
    if (arguments.direction == "across") placement.direction = LampDirection::across;
    if (arguments.pixels) placement.sampling.weight = SampleWeight::pixels;
    if (!arguments.rated.empty()) options.rated = read_rig_aloud(arguments.rated);
    if (!arguments.hits.empty()) options.hits = read_hits(arguments.hits);
    return options;
}

/// `view`: the only view whose lamps are summarised; empty: all.
void print_summary(const PlaceResult& result, const std::string& view,
                   const std::filesystem::path& output) {
    const Placement& placement = result.placement;
    const std::size_t rows = placement.planes.size();
    const StripeStatistics& stripes = placement.stripes;
    const double scale = 540.0 / result.views.front().camera.height;
    std::array<char, 80> reach{};
    std::snprintf(reach.data(), reach.size(), "%zu %s of lamps %s %.1f %% of the picture", rows,
                  rows == 1 ? "row" : "rows", rows == 1 ? "covers" : "cover",
                  100 * placement.coverage);
    std::array<char, 120> spacing{};
    if (placement.kind != LampKind::panel)
        std::snprintf(spacing.data(), spacing.size(),
                      ", stripes %.0f px apart (%.0f to %.0f) in one 540 high, %.0f %% of them as "
                      "wanted",
                      scale * stripes.median, scale * stripes.narrow, scale * stripes.wide,
                      100 * stripes.in_range);
    TextLines lines;
    std::ostream& line = lines.line();
    line << view << (view.empty() ? "" : ": ") << reach.data() << spacing.data();
    if (!output.empty()) line << "; see " << output.string();
    print(lines.text());
}

/// Path of a view's file: rig.toml of the view "front" is rig-front.toml.
std::filesystem::path of_view(const std::filesystem::path& path, const std::string& view) {
    if (path.empty()) return path;
    return path.parent_path() / (path.stem().string() + "-" + view + path.extension().string());
}

void place_one(const PlaceArguments& arguments, const Scene& scene, const PlaceOptions& options,
               const std::filesystem::path& output, const std::filesystem::path& report,
               const Job& job) {
    const PlaceResult result = place_scene(scene, options, job);
    if (!report.empty()) write_placement(report, scene, result, job);
    if (!output.empty()) write_rig(output, result.placement.rig);
    print_summary(result, arguments.each ? result.views.front().name : "", output);
}

void require_output(const PlaceArguments& arguments) {
    if (arguments.rated.empty() && arguments.output.empty())
        throw Error("", "--output", "say where the rig is to be written: -o RIG.toml");
    if (!arguments.rated.empty() && !arguments.output.empty())
        throw Error("", "--rate", "tells of a rig that is there; -o would write it again");
    if (!arguments.output.empty()) {
        require_rig_extension(arguments.output);
        require_place_for_file(arguments.output);
    }
    if (!arguments.report.empty()) require_place_for_folder(arguments.report);
}

void withdraw_earlier(const PlaceArguments& arguments) {
    const std::vector<std::string>& views = arguments.options.views;
    ResultPlaces places;
    if (!arguments.each) places.files.push_back(arguments.output);
    for (const std::string& view : views)
        if (arguments.each) places.files.push_back(of_view(arguments.output, view));
    std::vector<std::filesystem::path> inputs = arguments.scene.inputs;
    inputs.insert(inputs.end(), views.begin(), views.end());
    inputs.insert(inputs.end(), arguments.planes.begin(), arguments.planes.end());
    inputs.push_back(arguments.hits);
    inputs.push_back(arguments.rated);
    withdraw_results(places, inputs);
}

int place(const PlaceArguments& arguments, const Job& job) {
    require_output(arguments);
    withdraw_earlier(arguments);
    require_view_names(arguments.options.views);
    PlaceOptions options = placing(arguments);
    const Scene scene = arguments.scene.open(job);
    arguments.scene.warn_of_axes(scene, options.views);
    if (!arguments.each) {
        place_one(arguments, scene, options, arguments.output, arguments.report, job);
        return exit_pass;
    }
    for (const std::string& view : arguments.options.views) {
        options.views = {view};
        const auto report = arguments.report.empty() ? arguments.report : arguments.report / view;
        place_one(arguments, scene, options, of_view(arguments.output, view), report, job);
    }
    return exit_pass;
}

void add_choices(CLI::App& command, PlaceArguments& arguments) {
    PlacementOptions& placement = arguments.options.placement;
    command
        .add_option("--faces", arguments.options.faces,
                    "faces that count, by number or pattern of names; may repeat [all]")
        ->allow_extra_args(false);
    command
        .add_option("--plane", arguments.planes,
                    "where lamps may hang: above, front, left, rear, right, or the C-planes of a "
                    "rig file; may repeat [anywhere]")
        ->allow_extra_args(false);
    command.add_option("--planes", placement.planes, "rows of lamps at most")
        ->check(number_between(1, 16))
        ->capture_default_str();
    command
        .add_option("--lamp", arguments.kind,
                    "what hangs in a row: tubes, one luminous panel, or a screen of bright bars "
                    "as wide as the dark ones between them")
        ->check(CLI::IsMember({"tube", "panel", "screen"}))
        ->capture_default_str();
    command.add_option("--lamps", placement.lamps, "tubes or bars in a row; 0: as many as fit")
        ->check(number_between(0, 64))
        ->capture_default_str();
    command.add_option("--stripes", arguments.stripes,
                       "wanted spacing of the stripes, LEAST:MOST pixels of a picture 540 high "
                       "[12:60]");
    command
        .add_option("--direction", arguments.direction,
                    "lamps along the vehicle, across it, or as shows most")
        ->check(CLI::IsMember({"auto", "along", "across"}))
        ->capture_default_str();
    command.add_option("--samples", placement.sampling.samples, "places looked at in each view")
        ->check(number_between(100, 4e6))
        ->capture_default_str();
    command.add_flag("--weigh-pixels", arguments.pixels,
                     "every pixel counts the same, as in the paper, instead of its solid angle");
}

} // namespace

void add_place(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<PlaceArguments>();
    CLI::App& command =
        *app.add_subcommand("place", "hang lamps where the body mirrors them into the eye");
    arguments->scene.add_to(command, "MODEL|SCENE");
    arguments->scene.add_picture_size(command);
    command.add_option("-o,--output", arguments->output, "rig file to write");
    add_choices(command, *arguments);
    arguments->symmetry.add_to_placement(command);
    CLI::Option* views =
        command
            .add_option("--view", arguments->options.views,
                        "view by name, or auto; may repeat: one rig serves them all [auto]")
            ->allow_extra_args(false);
    command
        .add_option("--from", arguments->hits,
                    "hits that keiko render or inspect has registered, with their views, instead "
                    "of another look at the body")
        ->excludes(views)
        ->excludes("--size")
        ->excludes("--samples");
    command.add_flag("--each", arguments->each, "a rig for each view, RIG-VIEW.toml")->needs(views);
    command.add_option("--report", arguments->report,
                       "folder for placement.json, the histograms and a plan");
    command.add_option("--rate", arguments->rated, "rig file to tell of, instead of placing lamps");
    command.footer(
        "Example: keiko place hood.step -o hood-rig.toml --view high-front --report out");
    session.add_command(command, [arguments](const Job& job) { return place(*arguments, job); });
}

} // namespace keiko::cli
