#pragma once

#include "keiko/compare/fixture_record.h"
#include "keiko/workflow/place_scene.h"

namespace keiko {

/// Reads, measures and renders a fixture: from the eyes and under the lamps of `kept` as far as it
/// has those, which the record's setup states. The same for any number of threads. Throws Error,
/// Cancelled.
FixtureRecord run_fixture(const FixtureSpec& spec, const FixtureSetup& kept,
                          const LoadOptions& load, const Job& job = {});

/// SHA-256 of everything that run_fixture depends on: `kept`, the fixture `file` and all files that
/// it names, by their paths from its folder; this program and the worker that reads CAD files. The
/// libraries that they load are not part of it.
std::string fixture_key(const std::filesystem::path& file, const FixtureSetup& kept,
                        const LoadOptions& load);

} // namespace keiko
