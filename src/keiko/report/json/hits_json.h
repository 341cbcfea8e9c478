#pragma once

#include "keiko/placement/registered_hits.h"

#include <string>

namespace keiko {

/// The format keiko-hits/1 of docs/file-formats.md.
std::string hits_json(const RegisteredHits& hits, const std::string& tool_version);

/// Inverse of hits_json, bit for bit. `file` is for messages. Throws Error for any other text.
RegisteredHits hits_from_json(const std::string& text, const std::string& file);

} // namespace keiko
