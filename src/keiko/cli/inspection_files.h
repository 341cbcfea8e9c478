#pragma once

#include "keiko/api/check.h"
#include "keiko/base/file_transaction.h"

#include <CLI/App.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace keiko::cli {

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

private:
    enum class Format { json, junit, sarif, csv };
    struct File {
        std::filesystem::path path;
        Format format;
    };

    std::vector<File> files() const;

    std::vector<std::filesystem::path> json_, junit_, sarif_, csv_, outputs_;
};

} // namespace keiko::cli
