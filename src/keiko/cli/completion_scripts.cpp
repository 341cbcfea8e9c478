#include "keiko/cli/completion_scripts.h"

#include <algorithm>
#include <span>
#include <sstream>
#include <string_view>

namespace keiko::cli {
namespace {

std::string joined(std::span<const std::string> words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : std::string(between)) + word;
    return text;
}

/// The text with a backslash before each of `special`.
std::string escaped(std::string_view text, std::string_view special) {
    std::string result;
    for (const char c : text) {
        if (special.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

/// The text in single quotes, for bash and zsh.
std::string shell_word(std::string_view text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

/// Marks in the bash script that names of files are proposed.
constexpr std::string_view file_mark = "<file>";

std::string bash_words(const CompletionValue& value) {
    if (value.kind == ValueKind::file) return std::string(file_mark);
    return joined(value.choices, " ");
}

/// Cases of _keiko_words for one command; `command` is empty for the program itself.
void write_bash_cases(std::ostream& out, const std::string& command, const CompletionTree& tree) {
    const auto write = [&](const std::string& key, const std::string& words) {
        out << "        '" << command << ":" << key << "') echo " << shell_word(words) << " ;;\n";
    };
    std::vector<std::string> names, next;
    for (const CompletionOption& option : tree.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
        if (option.value.kind == ValueKind::none) continue;
        for (const std::string& name : option.names) write(name, bash_words(option.value));
    }
    for (const CompletionTree& below : tree.commands) next.push_back(below.name);
    for (const CompletionArgument& argument : tree.arguments)
        next.push_back(bash_words(argument.value));
    write("-", joined(names, " "));
    write("", joined(next, " "));
}

/// Bodies of the functions of the bash script, after the table.
constexpr std::string_view bash_functions = R"(        *) return 1 ;;
    esac
}

_keiko() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= words
    ((COMP_CWORD < 2)) || [[ ${COMP_WORDS[1]} == -* ]] || command=${COMP_WORDS[1]}
    # bash takes --option=value for three words.
    if [[ $word == = ]]; then
        word=
    elif [[ $before == = ]]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    [[ $before == -* ]] && words=$(_keiko_words "$command:$before") ||
        words=$(_keiko_words "$command:${word:+${word:0:1}}") ||
        words=$(_keiko_words "$command:") || return
    # Without a proposal of its own bash completes names of files.
    [[ " $words " != *' <file> '* ]] || compopt -o default
    COMPREPLY=($(compgen -W "${words//<file>/}" -- "$word"))
}

complete -F _keiko keiko
)";

std::string zsh_action(const CompletionValue& value) {
    if (value.kind == ValueKind::file) return "_files";
    if (value.kind == ValueKind::number) return " ";
    return "(" + joined(value.choices, " ") + ")";
}

/// An argument of zsh's _arguments for an option: "(-o
/// --output)"{-o+,--output=}"[...]:value:_files".
std::string zsh_option(const CompletionOption& option) {
    const bool has_value = option.value.kind != ValueKind::none;
    std::vector<std::string> names;
    for (const std::string& name : option.names)
        names.push_back(name + (!has_value ? "" : name.starts_with("--") ? "=" : "+"));
    const std::string spelt = names.size() > 1 ? "{" + joined(names, ",") + "}" : joined(names, "");
    const std::string before =
        option.value.repeats ? "'*'" : shell_word("(" + joined(option.names, " ") + ")");
    return before + spelt +
           shell_word("[" + escaped(option.description, "\\[]:") + "]" +
                      (has_value ? ":value:" + zsh_action(option.value) : ""));
}

std::string zsh_argument(const CompletionArgument& argument) {
    const std::string place = argument.value.repeats ? "*:" : ":";
    return shell_word(place + escaped(argument.name, "\\:") + ":" + zsh_action(argument.value));
}

void write_zsh_arguments(std::ostream& out, const CompletionTree& tree, std::string_view indent) {
    for (const CompletionOption& option : tree.options)
        out << " \\\n" << indent << zsh_option(option);
    for (const CompletionArgument& argument : tree.arguments)
        out << " \\\n" << indent << zsh_argument(argument);
}

std::string fish_value(const CompletionValue& value) {
    switch (value.kind) {
        case ValueKind::file:
            return " -r -F";
        case ValueKind::number:
            return " -x";
        case ValueKind::choice:
            return " -x -a '" + joined(value.choices, " ") + "'";
        case ValueKind::none:
            break;
    }
    return "";
}

/// Lines of fish for a command; `condition` says when they hold.
void write_fish_lines(std::ostream& out, const std::string& condition, const CompletionTree& tree) {
    const std::string line = "complete -c keiko -n '" + condition + "'";
    const auto described = [](const std::string& text) {
        return " -d '" + escaped(text, "\\'") + "'\n";
    };
    for (const CompletionOption& option : tree.options) {
        out << line;
        for (const std::string& name : option.names)
            out << (name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1));
        out << fish_value(option.value) << described(option.description);
    }
    for (const CompletionArgument& argument : tree.arguments)
        if (argument.value.kind == ValueKind::file)
            out << line << " -F\n";
        else if (argument.value.kind == ValueKind::choice)
            out << line << " -a '" << joined(argument.value.choices, " ") << "'\n";
    for (const CompletionTree& command : tree.commands)
        out << line << " -a " << command.name << described(command.description);
}

} // namespace

std::string bash_completion(const CompletionTree& program) {
    std::ostringstream out;
    out << "# Completion of keiko in bash, written by `keiko completion bash`.\n\n"
           "# What may follow, by COMMAND:OPTION, COMMAND:- for options, COMMAND: for the rest.\n"
           "_keiko_words() {\n"
           "    case $1 in\n";
    write_bash_cases(out, "", program);
    for (const CompletionTree& command : program.commands)
        write_bash_cases(out, command.name, command);
    out << bash_functions;
    return out.str();
}

std::string zsh_completion(const CompletionTree& program) {
    std::ostringstream out;
    out << "#compdef keiko\n"
           "# Completion of keiko in zsh, written by `keiko completion zsh`.\n\n"
           "_keiko() {\n"
           "    local curcontext=$curcontext state line\n"
           "    typeset -A opt_args\n"
           "    local -a commands=(\n";
    for (const CompletionTree& command : program.commands)
        out << "        " << shell_word(command.name + ":" + escaped(command.description, "\\"))
            << "\n";
    out << "    )\n    _arguments -C";
    write_zsh_arguments(out, program, "        ");
    out << " \\\n        '1:command:->command' '*::argument:->argument'\n"
           "    case $state in\n"
           "        command) _describe command commands ;;\n"
           "        argument)\n"
           "            case $words[1] in\n";
    for (const CompletionTree& command : program.commands) {
        out << "                " << command.name << ")\n                    _arguments -s -S";
        write_zsh_arguments(out, command, "                        ");
        out << " ;;\n";
    }
    out << "            esac ;;\n    esac\n}\n\n"
           "if [[ $funcstack[1] == _keiko ]]; then _keiko \"$@\"; else compdef _keiko keiko; fi\n";
    return out.str();
}

std::string fish_completion(const CompletionTree& program) {
    std::ostringstream out;
    out << "# Completion of keiko in fish, written by `keiko completion fish`.\n"
           "complete -c keiko -f\n";
    write_fish_lines(out, "__fish_use_subcommand", program);
    for (const CompletionTree& command : program.commands)
        write_fish_lines(out, "__fish_seen_subcommand_from " + command.name, command);
    return out.str();
}

} // namespace keiko::cli
