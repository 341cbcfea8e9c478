#include "keiko/cli/completion_scripts.h"
#include "keiko/cli/completion_tree.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/session.h"

#include <map>
#include <memory>

namespace keiko::cli {
namespace {

using ScriptWriter = std::string (*)(const CompletionTree&);

const std::map<std::string, ScriptWriter>& writers() {
    static const std::map<std::string, ScriptWriter> by_shell{
        {"bash", bash_completion}, {"fish", fish_completion}, {"zsh", zsh_completion}};
    return by_shell;
}

std::vector<std::string> shells() {
    std::vector<std::string> names;
    for (const auto& [name, writer] : writers()) names.push_back(name);
    return names;
}

} // namespace

void add_completion(CLI::App& app, Session& session) {
    auto shell = std::make_shared<std::string>();
    CLI::App& command = *app.add_subcommand(
        "completion", "print a script that completes half-typed commands in a shell");
    command.add_option("SHELL", *shell, "bash, fish or zsh")
        ->required()
        ->check(CLI::IsMember(shells()));
    command.footer(
        "Packages install it. Elsewhere, for the running shell:\n"
        "Example: keiko completion bash > keiko.bash && source keiko.bash");
    session.add_command(command, [shell, &app](const Job&) {
        print(writers().at(*shell)(completion_tree(app)));
        return exit_pass;
    });
}

} // namespace keiko::cli
