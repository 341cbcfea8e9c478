#pragma once

#include "keiko/api/accept.h"
#include "keiko/api/check.h"
#include "keiko/api/place.h"
#include "keiko/base/output_folder.h"

#include <CLI/App.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace keiko::cli {

/// Options for sections and iso-curves, and for the files to which they are written.
class CombArguments {
public:
    /// Adds --section and --iso-curves to a command.
    void add_to(CLI::App& command);
    /// Adds --combs, for a command that writes no folder.
    void add_files(CLI::App& command);

    /// Options for comb_curves. Throws Error for an invalid plane.
    CombOptions options(double join) const;
    /// Throws Error if curves are requested without a file, or the reverse, and for a file that
    /// cannot be written or whose ending names no format. `as_curves`: --curves names files of
    /// them.
    void require_places(bool as_curves = false) const;
    /// The files that the options name; pictures of several planes have other names.
    const std::vector<std::filesystem::path>& files() const { return files_; }
    /// Adds every requested file; pictures of several planes are FILE-PLANE.svg.
    void add_to(FileTransaction& batch, const Combs& combs) const;

private:
    std::vector<std::string> planes_;
    int iso_curves_ = 0;
    std::vector<std::filesystem::path> files_;
};

/// The STEP and IGES files to which curves are written.
class CurveFilesOption {
public:
    /// Adds --curves to a command, with its help.
    void add_to(CLI::App& command, const char* text);

    /// Throws Error for a file that cannot be written, is requested twice or whose ending names no
    /// format.
    void require_places() const;
    /// The files that the option names.
    const std::vector<std::filesystem::path>& files() const { return files_; }

private:
    std::vector<std::filesystem::path> files_;
};

/// The files to which profiles of seams are written.
class ProfileArguments {
public:
    /// Adds --profiles to a command.
    void add_to(CLI::App& command);

    /// Throws Error for a file that cannot be written, is requested twice or whose ending names no
    /// format.
    void require_places() const;
    /// The files that the option names.
    const std::vector<std::filesystem::path>& files() const { return files_; }
    /// Adds every requested file.
    void add_to(FileTransaction& batch, const CheckResult& result) const;

private:
    std::vector<std::filesystem::path> files_;
};

/// The files in which an inspection is reported to other programs, as requested by the user.
class InspectionFiles {
public:
    /// Adds --junit, --sarif and --csv to a command.
    void add_to(CLI::App& command);
    /// Adds --json, and -o, whose ending selects the format.
    void add_json_and_output(CLI::App& command);

    /// Throws Error if a file cannot be written, has an ending that names no format, is requested
    /// twice or is one of the model files, `inputs`.
    void require_places(std::span<const std::filesystem::path> inputs) const;
    /// The files that the options name. Throws Error for an ending that names no format.
    std::vector<std::filesystem::path> paths() const;
    /// Adds every requested file.
    void add_to(FileTransaction& batch, const Inspection& inspection) const;

    /// The folder that -o names for a shard. Throws Error unless it names one place.
    std::filesystem::path folder() const;
    /// A file of each format for a folder: inspection.json, junit.xml, findings.sarif and
    /// findings.csv.
    static FolderContent every_format(const Inspection& inspection);

private:
    enum class Format { json, junit, sarif, csv };
    static std::string text_of(Format format, const Inspection& inspection);
    struct File {
        std::filesystem::path path;
        Format format;
    };

    std::vector<File> files() const;

    std::vector<std::filesystem::path> json_, junit_, sarif_, csv_, outputs_;
};

/// The day on which acceptances are applied or given.
class DateOption {
public:
    /// Adds --today to a command.
    void add_to(CLI::App& command);
    /// "2026-11-27". Throws Error for a text that is no date.
    std::string date() const;

private:
    std::string date_;
};

/// The file of findings that have no part in the verdict.
class AcceptedOption {
public:
    /// Adds --accepted and --today to a command.
    void add_to(CLI::App& command);
    /// The file, or an empty path.
    const std::filesystem::path& file() const { return file_; }
    /// Its acceptances; none without a file. Throws Error.
    AcceptanceList list() const;
    /// Day on which results depend; empty without a file.
    std::string day() const { return file_.empty() ? "" : today_.date(); }

private:
    std::filesystem::path file_;
    DateOption today_;
};

/// Warns of acceptances that cover nothing.
void warn_of_acceptances(const Inspection& inspection);

/// The plane about which a body, and the lamps over it, are symmetric.
class SymmetryOption {
public:
    /// Adds --symmetry to a command that places lamps.
    void add_to_placement(CLI::App& command);
    /// Adds --symmetry and --symmetry-limit to a command that judges a body; `also_places`: it
    /// places lamps too.
    void add_to(CLI::App& command, bool also_places);
    /// Symmetry of the lamps: automatic if not requested. Throws Error for an invalid plane.
    SymmetryChoice choice() const;
    /// Replaces the preset's symmetry: a plane is judged, "off" is not. Throws Error for an invalid
    /// plane, and for a limit without one.
    void apply_to(CriteriaPreset& preset) const;
    /// Makes a symmetry that is found deserve a look, if "auto" is requested and the preset judges
    /// no plane.
    void look_in(CriteriaPreset& preset) const;

private:
    std::string plane_;
    double limit_ = 0; ///< mm; 0: the preset's own, or that of SymmetryLimit
};

} // namespace keiko::cli
