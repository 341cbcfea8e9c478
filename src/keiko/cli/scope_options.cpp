#include "keiko/cli/scope_options.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/session.h"

namespace keiko::cli {

void ScopeOptions::add_to(CLI::App& command) {
    const auto add = [&](const char* name, std::vector<std::string>& words, const char* text) {
        command.add_option(name, words, text)->allow_extra_args(false)->check(not_empty());
    };
    add("--faces", faces_,
        "judge these faces alone, by number or pattern of names; may repeat [all]");
    add("--layers", layers_, "judge the faces of these layers alone, by pattern; may repeat [all]");
    add("--colors", colors_, "judge the faces of these colours alone, #RRGGBB; may repeat [all]");
    add("--zone", zones_,
        "judge the faces of this zone of the preset alone, or outer-skin: those that are visible "
        "from outside; may repeat [all]");
}

Scope ScopeOptions::scope() const {
    Scope scope;
    scope.selection.faces = faces_, scope.selection.layers = layers_, scope.zones = zones_;
    for (const std::string& color : colors_) {
        try {
            scope.selection.colors.push_back(FaceColor::parse(color));
        } catch (const Error& error) {
            throw Error("", "--colors", error.reason());
        }
    }
    return scope;
}

void print_scope(const std::optional<JudgedScope>& scope, const CriteriaPreset& preset) {
    TextLines lines;
    for (const std::string& sentence : scope_sentences(scope, preset)) lines.line() << sentence;
    print(lines.text());
}

} // namespace keiko::cli
