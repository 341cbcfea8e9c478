#include "keiko/base/memory.h"
#include "keiko/base/text.h"
#include "keiko/cli/mesh.h"
#include "keiko/cli/session.h"

#include <csignal>
#include <cstdio>
#include <exception>

int main(int argc, char** argv) try {
    using namespace keiko;
    keep_freed_memory();
    std::signal(SIGXFSZ, SIG_IGN); // a file beyond `ulimit -f` is an error of the call instead
    cli::Session session;
    CLI::App app("Keiko judges free-form surfaces by the reflections of parallel lamps.", "keiko");
    cli::add_version(app);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 pass, 1 findings, 2 error, 130 interrupted.\n"
        "Example: keiko inspect fender.step -o out");
    cli::add_accept(app, session);
    cli::add_check(app, session);
    cli::add_compare(app, session);
    cli::add_completion(app, session);
    cli::add_draw(app, session);
    cli::add_illuminance(app, session);
    cli::add_info(app, session);
    cli::add_inspect(app, session);
    cli::add_lines(app, session);
    cli::add_merge(app, session);
    cli::add_mesh(app, session);
    cli::add_mesh_error(app, session);
    cli::add_panorama(app, session);
    cli::add_place(app, session);
    cli::add_radiosity(app, session);
    cli::add_regress(app, session);
    cli::add_render(app, session);
    cli::add_trace(app, session);
    cli::add_view(app, session);
    return session.run(app, argc, argv);
} catch (const std::exception& error) {
    std::fprintf(stderr, "keiko: %s\n", keiko::one_line(error.what()).c_str());
    return keiko::cli::exit_error;
}
