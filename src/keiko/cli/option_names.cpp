#include "keiko/cli/option_names.h"

#include <string_view>

namespace keiko::cli {
namespace {

struct OptionName {
    std::string_view field, option;
};

/// Fields whose option has another name.
constexpr OptionName renamed[] = {
    {"columns", "--out"},
    {"hits", "--from"},
    {"views", "--view"},
};

std::string option_of(std::string_view field) {
    for (const OptionName& name : renamed)
        if (name.field == field) return std::string(name.option);
    return "--" + std::string(field);
}

} // namespace

std::string option_error_line(const FieldError& error, const CLI::App& command) {
    const std::string option = option_of(error.field());
    if (!command.get_option_no_throw(option)) return error.what();
    return Error("", option, error.reason()).what();
}

} // namespace keiko::cli
