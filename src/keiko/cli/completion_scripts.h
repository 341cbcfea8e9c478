#pragma once

#include "keiko/cli/completion_tree.h"

#include <string>

namespace keiko::cli {

// Each script completes commands, options, the words of a choice, and names of files.

/// Script that bash reads by `source`, or from share/bash-completion/completions.
std::string bash_completion(const CompletionTree& program);
/// Function that zsh finds as the file _keiko in its fpath.
std::string zsh_completion(const CompletionTree& program);
/// Script that fish finds in vendor_completions.d.
std::string fish_completion(const CompletionTree& program);

} // namespace keiko::cli
