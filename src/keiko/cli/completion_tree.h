#pragma once

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace keiko::cli {

/// Kind of the values that an option or an argument takes, for the completion of a half-typed one.
enum class ValueKind {
    none,   ///< no value: a flag
    number, ///< nothing to propose
    choice, ///< one of a few words
    file    ///< any other text: names of files are proposed
};

/// Values that an option or an argument takes.
struct CompletionValue {
    ValueKind kind = ValueKind::none;
    std::vector<std::string> choices; ///< of ValueKind::choice
    bool repeats = false;             ///< several may follow
};

/// An option of a command.
struct CompletionOption {
    std::vector<std::string> names; ///< as typed: "-o", "--output"
    std::string description;
    CompletionValue value;
};

/// An argument that has a place instead of a name.
struct CompletionArgument {
    std::string name; ///< as in the help: "MODEL"
    CompletionValue value;
};

/// A command with all that a shell may propose after it: options, arguments and sub-commands.
struct CompletionTree {
    std::string name, description;
    std::vector<CompletionOption> options;
    std::vector<CompletionArgument> arguments;
    std::vector<CompletionTree> commands;
};

/// The command tree of an app, in the order of its help.
CompletionTree completion_tree(const CLI::App& app);

} // namespace keiko::cli
