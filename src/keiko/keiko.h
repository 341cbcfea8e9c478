#pragma once

#include "keiko/base/error.h"
#include "keiko/film/false_color_picture.h"
#include "keiko/film/image_file.h"
#include "keiko/inspect/inspection.h"
#include "keiko/io/load_model.h"
#include "keiko/io/luminaire_file.h"
#include "keiko/io/material_file.h"
#include "keiko/io/preset_file.h"
#include "keiko/io/rig_file.h"
#include "keiko/patch/seam.h"
#include "keiko/placement/best_view.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/placement/registered_hits.h"
#include "keiko/render/picture.h"
#include "keiko/report/checks_csv.h"
#include "keiko/report/combs_text.h"
#include "keiko/report/facts_text.h"
#include "keiko/report/inspection_text.h"
#include "keiko/report/junit.h"
#include "keiko/report/line_checks.h"
#include "keiko/report/lines_json.h"
#include "keiko/report/luminaire_facts.h"
#include "keiko/report/polar_curve.h"
#include "keiko/report/report.h"
#include "keiko/report/report_json.h"
#include "keiko/report/sarif.h"
#include "keiko/report/unmet_borders.h"
#include "keiko/rig/luminaire_remarks.h"
#include "keiko/spec/axes_remark.h"
#include "keiko/spec/criteria_preset.h"
#include "keiko/spec/suggestion.h"
#include "keiko/spec/symmetry_choice.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The facade: what Keiko does, as free functions from value to value. Front ends use nothing else.
namespace keiko {

/// "0.1.0"
std::string version();

struct SceneOptions {
    LoadOptions load;
    std::string material = "black-show-car"; ///< of models that no scene file paints
    bool clipping_only = false;              ///< trace by Bezier clipping alone, see TracerOptions
    bool shadows = false;                    ///< bodies cast shadows, in pictures and numbers
    double frame = 0;                        ///< of a scene file with [[animation]]
};

struct FactsOptions {
    LoadOptions load;
    double join = 0.5;    ///< mm, within which two borders count as a seam
    bool tracing = false; ///< build the tracer too, and tell what it takes
};

/// Reads a model file and tells what is in it.
ModelFacts file_facts(const std::filesystem::path& file, const FactsOptions& options = {},
                      const Job& job = {});

struct CheckOptions {
    LoadOptions load;
    CriteriaPreset preset = standard_presets().front();
    double join = 0.5; ///< mm
    CombOptions combs{};
};

/// Curves with how they bend all along, as files have them.
struct Combs {
    std::vector<CombCurve> curves;
    std::vector<std::string> remarks; ///< of planes that miss the body, touch it or hold faces
    std::string json, csv;
    std::vector<CombPicture> pictures;
};

/// Whether the options ask for any curve.
bool has_curves(const CombOptions& options);
/// The sections and iso-curves of a body.
Combs combs_of(const SurfaceModel& model, const CombOptions& options, const Job& job = {});

/// What a check made.
struct CheckResult {
    Inspection inspection;
    std::optional<Combs> combs{}; ///< where any were asked for
};

/// Reads models, which together form one body, or one scene file (.toml), and holds their geometry
/// against criteria, without lamps or pictures. Throws Error for input that cannot be read.
CheckResult check_models(std::span<const std::filesystem::path> inputs,
                         const CheckOptions& options = {}, const Job& job = {});

/// The body on its ground, as pictures show it: the faces of the body, then that of the ground.
struct Surroundings {
    double ground = 0; ///< mm, its z
    std::vector<Material> materials;
    Tracer tracer;
};

/// A body ready to be looked at.
struct Scene {
    SurfaceModel model;
    std::vector<Material> materials; ///< one a face of the model
    Tracer tracer;
    std::optional<Occluders> occluders; ///< of what is seen, if it shall cast shadows
    std::optional<Camera> camera;       ///< as the scene file has it
    std::optional<std::string> view;    ///< a named view of the scene file
    std::optional<LightRig> rig;
    Rgb background{0};
    int width = 960, height = 540;
    std::optional<Surroundings> surroundings{}; ///< of a scene file with [ground]
    std::optional<int> max_depth{};             ///< as the scene file has them, else as
    std::optional<double> min_weight{};         ///< PictureOptions

    /// What pictures and traced rays see: the body, and the ground if there is one.
    const Tracer& seen() const { return surroundings ? surroundings->tracer : tracer; }
    const std::vector<Material>& seen_materials() const {
        return surroundings ? surroundings->materials : materials;
    }
    /// What pictures show under a rig, which is only looked at, as is the scene.
    PictureScene picture(const LightRig& under) const {
        return {seen(), seen_materials(), under, background, occluders ? &*occluders : nullptr};
    }
    /// Of its pictures, in pixels; of its camera too.
    void set_picture_size(int wide, int high);
    /// The number that files and reports give a face of what is seen; 0: the ground.
    std::uint32_t face_id(std::size_t face) const {
        return face < model.faces.size() ? model.faces[face].id : 0;
    }
};

/// What a scene file says of how far reflections are followed, before what `options` says.
PictureOptions picture_options(const Scene& scene, PictureOptions options = {});

/// Opens models, which together form one body, or one scene file (.toml). Throws Error for input
/// that cannot be read.
Scene open_scene(std::span<const std::filesystem::path> inputs, const SceneOptions& options = {},
                 const Job& job = {});

/// The same scene with its body moved; ground, lamps and camera stay. `options` as it was opened
/// by.
Scene moved_scene(Scene scene, const Affine& motion, const SceneOptions& options = {},
                  const Job& job = {});

/// A picture to be made: the views asked for by name, "auto" being the one that shows the body
/// best, "scene" the scene file's own and NAME.toml that of a view file. No names: the scene's own,
/// or else `automatic` views from different sides, the best first. Throws Error for an unknown
/// name.
std::vector<NamedView> choose_views(const Scene& scene, std::span<const std::string> names,
                                    int automatic, const Job& job = {});

/// Throws Error for a name that choose_views would refuse for any scene, or a view file that it
/// could not read: before the long work.
void require_view_names(std::span<const std::string> names);

/// Pictures are named after views. Throws Error where two have the same name.
void require_different_names(std::span<const NamedView> views);

/// Renders one picture of the scene under a rig.
Film render_view(const Scene& scene, const LightRig& rig, const Camera& camera,
                 const PictureOptions& options = {}, const Job& job = {});

/// Registered hits as a file keeps them, and read from one. Throws Error for any other file.
std::string hits_text(const RegisteredHits& hits);
RegisteredHits read_hits(const std::filesystem::path& file);

struct PlaceOptions {
    std::vector<std::string> views;       ///< names; empty: the best one
    std::vector<std::string> faces;       ///< numbers or patterns of names; empty: all count
    std::optional<LightRig> rated{};      ///< tells of these lamps instead of placing others
    std::optional<RegisteredHits> hits{}; ///< instead of another look at the body; with their views
    PlacementOptions placement;           ///< but for its `sampling.faces` and `mirror`
    /// What lamps are symmetric about, where views and body are (placement.md#symmetry).
    SymmetryChoice symmetry{SymmetryChoice::Kind::automatic};
};

struct PlaceResult {
    std::vector<NamedView> views;
    Placement placement;
};

/// Hangs lamps where the body mirrors them into the eyes of all views. Throws Error for a pattern
/// that no face matches, and for hits of another body.
PlaceResult place_scene(const Scene& scene, const PlaceOptions& options = {}, const Job& job = {});

/// Writes placement.json, histogram-N.png for each plane and plan.png (body, lamps and eyes from
/// above) into a folder.
void write_placement(const std::filesystem::path& folder, const Scene& scene,
                     const PlaceResult& result, const Job& job = {});

struct LinesOptions {
    std::vector<std::string> views;           ///< names; empty: one, as choose_views has it
    std::optional<std::filesystem::path> rig; ///< none: the scene's own
    SurfaceLineOptions lines;
    CriteriaPreset preset = standard_presets().front();
    double join = 0.5; ///< mm
};

/// The reflection lines, highlight lines or isophotes of a rig's lamps that views of a scene show
/// on the body, joined over seams, measured and judged there. Throws Error without a rig, and for
/// one without C-planes.
LineList find_lines(const Scene& scene, const LinesOptions& options = {}, const Job& job = {});

/// The stripes of the lamps in one view of a list with its lines drawn over them and their
/// crossings marked by verdict, the worst of the list numbered as the table has them.
Image lines_picture(const Scene& scene, const LinesOptions& options, const LineList& list,
                    std::size_t view, const Job& job = {});

struct InspectOptions {
    std::vector<std::string> views;           ///< names; empty: three automatic ones
    std::optional<std::filesystem::path> rig; ///< none: the scene's own, or else placed
    CriteriaPreset preset = standard_presets().front();
    double join = 0.5;          ///< mm
    PlacementOptions placement; ///< but for its `mirror`
    /// What placed lamps are symmetric about, where views and body are.
    SymmetryChoice symmetry{SymmetryChoice::Kind::automatic};
    PictureOptions picture;
    bool register_hits = false; ///< of the views, for InspectResult::hits
    CombOptions combs{};
};

/// What an inspection made: to be written, or looked at.
struct InspectResult {
    Report report;
    LightRig rig;
    std::optional<RegisteredHits> hits{};
    std::optional<Combs> combs{};                    ///< where any were asked for
    std::vector<std::pair<std::string, Film>> films; ///< by view name
};

/// The main job: place the lamps, render the views, measure the seams, and tell of them.
InspectResult inspect_scene(const Scene& scene, const InspectOptions& options = {},
                            const Job& job = {});

/// report.html, report.json, the pictures (PNG and EXR) and rig.toml, for a folder: its path is
/// what the rig names its files from.
FolderContent result_files(const std::filesystem::path& folder, const InspectResult& result);

} // namespace keiko
