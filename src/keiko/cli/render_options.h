#pragma once

#include "keiko/api/render.h"
#include "keiko/cli/scene_options.h"

#include <optional>
#include <string>
#include <vector>

namespace keiko::cli {

/// An analysis mode and the curvature at which its colours are saturated, 1/mm or 1/mm2; without
/// one, the picture's default.
struct ChosenMode {
    AnalysisMode look = AnalysisMode::zebra;
    std::optional<double> full{};
};

/// First and last frame.
struct Frames {
    int first = 0, last = 0;
};

/// The options of the command that renders one picture, or one a frame.
class RenderArguments {
public:
    SceneArguments scene;
    std::filesystem::path output, hits;
    std::string view, rig = "auto";
    bool false_color = false, iso_lines = false, resume = false;
    double light_error = PictureOptions().light_error;
    int edge_samples = PictureOptions().edge_samples;

    void add_to(CLI::App& command);

    /// Throws Error for options that exclude each other or do not suit the requested file, and for
    /// a place that cannot be written to.
    void require() const;
    /// Chosen analysis mode; nullopt for a picture under the lamps. Throws Error for an unknown
    /// name.
    std::optional<ChosenMode> look() const;
    std::vector<Aov> aovs() const { return aovs_by_names(aovs_); }
    FalseColorScale scale() const;
    ShownQuantity quantity() const;
    ToneMapping mapping() const;
    TubeModel tubes() const;
    /// Frames of an animation; nullopt for one picture.
    std::optional<Frames> frames() const;
    /// Key of all inputs of a picture except the number of its frame.
    std::string key() const;

private:
    void add_light(CLI::App& command);
    void add_false_colors(CLI::App& command);
    void add_display(CLI::App& command);
    void add_frames(CLI::App& command);
    void require_look(const ChosenMode& look) const;

    std::string aovs_, look_ = "lamps", scale_, quantity_ = "luminance", penumbrae_ = "width",
                       tone_ = "linear", frames_;
    std::optional<double> ev_;
    std::vector<const CLI::Option*> of_lamps_; ///< options that only pictures under the lamps use
    const CLI::Option* rig_ = nullptr;
};

} // namespace keiko::cli
