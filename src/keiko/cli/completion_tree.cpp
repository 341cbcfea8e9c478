#include "keiko/cli/completion_tree.h"

#include <sstream>
#include <string_view>

namespace keiko::cli {
namespace {

/// Words of "TEXT:{auto,along,across}", the name that CLI11 gives to the type of a choice.
std::vector<std::string> choices_of(const std::string& type) {
    std::vector<std::string> choices;
    const std::size_t begin = type.find('{'), end = type.find('}');
    if (begin == std::string::npos || end == std::string::npos) return choices;
    std::istringstream words(type.substr(begin + 1, end - begin - 1));
    for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
    return choices;
}

bool is_number(std::string_view type) {
    return type.starts_with("INT") || type.starts_with("UINT") || type.starts_with("FLOAT");
}

CompletionValue value_of(const CLI::Option& option) {
    CompletionValue value;
    if (option.get_items_expected_max() == 0) return value;
    const std::string type = option.get_type_name();
    value.choices = choices_of(type);
    value.kind = !value.choices.empty() ? ValueKind::choice
                 : is_number(type)      ? ValueKind::number
                                        : ValueKind::file;
    value.repeats = option.get_items_expected_max() > 1;
    return value;
}

CompletionOption completion_option(const CLI::Option& option) {
    CompletionOption result{{}, option.get_description(), value_of(option)};
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
    return result;
}

} // namespace

CompletionTree completion_tree(const CLI::App& app) {
    CompletionTree tree{app.get_name(), app.get_description(), {}, {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        if (option->nonpositional())
            tree.options.push_back(completion_option(*option));
        else
            tree.arguments.push_back({option->get_name(true), value_of(*option)});
    }
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        tree.commands.push_back(completion_tree(*command));
    return tree;
}

} // namespace keiko::cli
