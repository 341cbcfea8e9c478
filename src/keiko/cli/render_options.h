#pragma once

#include "keiko/api/render.h"
#include "keiko/cli/scene_options.h"

#include <optional>
#include <string>
#include <vector>

namespace keiko::cli {

/// Two eyes instead of one.
struct ChosenStereo {
    StereoLayout layout = StereoLayout::side_by_side; ///< of both pictures in one
    Stereo eyes{};                                    ///< as given, else the defaults
};

/// Frames of an animation.
struct Frames {
    int first = 0; ///< the first, at least 0
    int last = 0;  ///< the last, at least `first` and below 1000000
};

/// The options of the command that renders one picture, or one a frame.
class RenderArguments {
public:
    SceneArguments scene;         ///< what is rendered
    std::filesystem::path output; ///< picture, .exr or .png
    std::filesystem::path hits;   ///< .json for what the picture reflects; empty: none
    std::string view;             ///< view by name, "auto" or "scene"; empty: not given
    std::string rig = "auto";     ///< rig file, or "auto"
    bool false_color = false;     ///< --false-color
    bool iso_lines = false;       ///< --iso-lines
    bool resume = false;          ///< --resume
    double light_error = PictureOptions().light_error; ///< share, 0 to 0.1
    int edge_samples = PictureOptions().edge_samples;  ///< a side of a pixel, 1 to 16
    int gather_rays = 0; ///< at each pixel, 0 to 65536; 0: light of surfaces is interpolated

    /// Adds all options to a command.
    void add_to(CLI::App& command);

    /// Reads the analysis, if there is one, and takes the look of the view that is rendered, unless
    /// the user states one. Throws Error, and for a look that only the page of the viewer draws.
    void take_analysis();
    /// Throws Error for options that exclude each other or do not suit the requested file, and for
    /// a place that cannot be written to.
    void require() const;
    /// Chosen analysis mode; nullopt for a picture under the lamps. Throws Error for an unknown
    /// name, for a setting of another mode, and for one out of range.
    std::optional<ChosenMode> look() const;
    /// The mesh that is shown in place of the surface; nullopt for the surface itself. Throws Error
    /// for an unknown kind, and for a setting of meshes without one.
    std::optional<MeshLook> mesh_look() const;
    /// Layers of an .exr, in the order given. Throws Error for an unknown name and for a repeated
    /// one.
    std::vector<Aov> aovs() const { return aovs_by_names(aovs_); }
    /// Scale of false colours, cd/m2 or lx; by default FalseColorScale(). Throws Error unless
    /// 0 < minimum < maximum, both finite, or if there are no false colours.
    FalseColorScale scale() const;
    /// Quantity of false colours, luminance by default.
    ShownQuantity quantity() const;
    /// Curve and exposure of a .png.
    ToneMapping mapping() const;
    /// Model of tubes for --penumbrae.
    TubeModel tubes() const;
    /// Both eyes; nullopt for one.
    std::optional<ChosenStereo> stereo() const;
    /// Frames of an animation; nullopt for one picture.
    std::optional<Frames> frames() const;
    /// Key of all inputs of a picture except the number of its frame.
    std::string key() const;

private:
    void add_light(CLI::App& command);
    void add_false_colors(CLI::App& command);
    void add_display(CLI::App& command);
    void add_looks(CLI::App& command);
    void add_stereo(CLI::App& command);
    void add_frames(CLI::App& command);
    /// Settings of a mode.
    AnalysisOptions look_options(const StatedLook& look) const;
    void require_look(const ChosenMode& look) const;
    void require_mesh_look() const;

    std::string aovs_, look_ = "lamps", scale_, quantity_ = "luminance", penumbrae_ = "width",
                       tone_ = "linear", frames_, pull_, section_, stereo_,
                       hidden_surfaces_ = "z-buffer", mesh_shadows_ = "none", mesh_;
    double eye_distance_ = Stereo().eye_distance;
    std::optional<double> ev_, draft_, radius_, screen_distance_;
    std::vector<const CLI::Option*> of_lamps_;   ///< options that only pictures under the lamps use
    std::vector<const CLI::Option*> of_surface_; ///< of these, those that meshes do not have
    Vec3 viewed_across_ = ChosenMode().section;  ///< --section of the analysis's view
    const CLI::Option *rig_ = nullptr, *stated_look_ = nullptr, *stated_hidden_ = nullptr,
                      *stated_mesh_shadows_ = nullptr;
};

} // namespace keiko::cli
