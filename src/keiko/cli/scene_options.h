#pragma once

#include "keiko/api/check.h"
#include "keiko/api/place.h"
#include "keiko/api/render.h"
#include "keiko/api/scene.h"

#include <CLI/App.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keiko::cli {

/// Size in pixels; 0: the scene's own.
struct PictureSize {
    int width = 0;  ///< 1 to 16384, or 0
    int height = 0; ///< 1 to 16384, or 0
};

/// The options of every command that reads a body.
struct SceneArguments {
    std::vector<std::filesystem::path> inputs; ///< models of one body, or one scene file
    SceneOptions options;                      ///< as given, without the limits of import below
    std::string size;                          ///< WIDTHxHEIGHT; empty: the scene's own
    std::string intersector = "proving";       ///< "proving" or "clipping"
    double import_timeout = 120;               ///< s
    std::optional<double> import_memory;       ///< GiB; nullopt: see usual_memory_limit()
    double cache_limit = 4;                    ///< GiB
    std::filesystem::path analysis;            ///< file of an analysis; empty: none
    std::filesystem::path solution;            ///< of reflected light; empty: none

    /// Adds the inputs (as `what`) and options to a command.
    void add_to(CLI::App& command, const std::string& what);
    /// Adds the options alone.
    void add_reading(CLI::App& command);
    /// Adds the size of the pictures that a command makes.
    void add_picture_size(CLI::App& command);
    /// Adds the option that bodies cast shadows.
    void add_shadows(CLI::App& command);
    /// Adds the analysis that is done again.
    void add_analysis(CLI::App& command);
    /// Adds the solution whose reflected light the scene has.
    CLI::Option* add_solution(CLI::App& command);
    /// Reads the analysis into the options, if there is one, and warns of contradictions within its
    /// luminaires. Throws Error.
    void read_analysis();
    /// Options of the scene, with the limits of import and the intersector.
    SceneOptions scene_options() const;
    /// Throws Error for an invalid --size.
    PictureSize picture_size() const;
    /// Opens the scene, and warns of every face that could not be read, and of what could not be
    /// followed of an analysis.
    Scene open(const Job& job) const;
    /// Warns if views are requested by name for models that plainly do not lie in the vehicle
    /// frame, unless --axes is given.
    void warn_of_axes(const Scene& scene, std::span<const std::string> views) const;
};

/// AOVs by their comma-separated names; none for an empty text. Throws Error for an unknown name
/// and for one that stands twice.
std::vector<Aov> aovs_by_names(const std::string& names);

/// Warns of every remark, by its subject.
void log_remarks(const Diagnostics& remarks);

/// Reads a rig file, and warns of contradictions within its luminaires.
LightRig read_rig_aloud(const std::filesystem::path& file);

/// Adds only the options for reading model files.
void add_load_options(CLI::App& command, SceneArguments& arguments);
/// Options for reading model files: the timeout rounded to ms, memory and cache in bytes.
LoadOptions load_options(const SceneArguments& arguments);

} // namespace keiko::cli
