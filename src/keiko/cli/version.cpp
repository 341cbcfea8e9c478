#include "keiko/api/model.h"
#include "keiko/cli/session.h"

#include <memory>

namespace keiko::cli {

void add_version(CLI::App& app) {
    auto verbose = std::make_shared<bool>(false);
    // Before --version, whose action must know it: CLI11 acts on options in the order of addition.
    CLI::Option* details = app.add_flag(
        "--verbose", *verbose, "with --version: tell the build, the CAD reader and the libraries");
    details->needs(app.set_version_flag("--version", [verbose] {
        std::string text = *verbose ? build_text(build_facts()) : version();
        if (text.ends_with('\n')) text.pop_back();
        return text;
    }));
}

} // namespace keiko::cli
