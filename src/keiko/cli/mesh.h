#pragma once

#include "keiko/cli/session.h"

namespace keiko::cli {

/// Adds `keiko mesh`.
void add_mesh(CLI::App& app, Session& session);

} // namespace keiko::cli
