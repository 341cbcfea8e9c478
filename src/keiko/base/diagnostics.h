#pragma once

#include <string>
#include <vector>

namespace keiko {

enum class Severity { note, warning, error };

/// A remark on the input that did not stop the work: a repaired loop, a face left out.
struct Diagnostic {
    Severity severity = Severity::note;
    std::string entity; ///< what it is about, e.g. "face 12 (fender-outer)"; may be empty
    std::string message;
};

/// Returned beside a result, never printed by the library.
using Diagnostics = std::vector<Diagnostic>;

} // namespace keiko
