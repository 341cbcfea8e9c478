#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/inspection.h"

#include <cstdint>
#include <optional>
#include <string>

namespace KEIKO_API keiko {

/// Index into Inspection::seams of the stretch that has a number in a report (keiko-report/1). It
/// lies between the same faces, with the same ends to within a micrometre. nullopt if the report
/// has no such number, or the inspection no such stretch. Throws Error naming `file` for another
/// text.
std::optional<std::uint32_t> stretch_of_report(const std::string& text, const std::string& file,
                                               std::uint32_t number, const Inspection& inspection);

} // namespace keiko
