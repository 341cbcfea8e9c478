#pragma once

#include "keiko/keiko.h"

#include <CLI/App.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace keiko::cli {

/// The files in which an inspection is told to other programs, as the user asked for them.
class InspectionFiles {
public:
    /// Adds --junit, --sarif and --csv to a command.
    void add_to(CLI::App& command);
    /// Adds --json, and -o, whose format is told by the ending.
    void add_json_and_output(CLI::App& command);

    /// Throws Error where a file cannot be written or has an ending that names no format.
    void require_places() const;
    /// Writes every file that was asked for; `inputs` are the model files.
    void write(const Inspection& inspection, std::span<const std::filesystem::path> inputs) const;

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
