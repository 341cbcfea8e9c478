#pragma once

#include "keiko/cli/session.h"

namespace keiko::cli {

/// Each function adds one command of `keiko` to the app.
void add_check(CLI::App& app, Session& session);
void add_compare(CLI::App& app, Session& session);
void add_illuminance(CLI::App& app, Session& session);
void add_info(CLI::App& app, Session& session);
void add_inspect(CLI::App& app, Session& session);
void add_lines(CLI::App& app, Session& session);
void add_merge(CLI::App& app, Session& session);
void add_place(CLI::App& app, Session& session);
void add_regress(CLI::App& app, Session& session);
void add_render(CLI::App& app, Session& session);
void add_trace(CLI::App& app, Session& session);

} // namespace keiko::cli
