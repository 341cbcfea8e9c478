#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/report/markup/junit_suites.h"

#include <string>

namespace keiko {

/// What a check came to, of the file that it was made on.
JunitCase check_case(const std::string& source, const Check& check);

/// An inspection for build servers, as JUnit XML (the schema of the xUnit plugin of Jenkins,
/// junit-10.xsd): one suite, one case a seam and criterion. A limit that is passed over is a
/// failure, one that a value cannot be told from and a face that was lost an error; what could not
/// be judged is skipped. It holds no time, so that every run gives the same bytes.
std::string junit_xml(const Inspection& inspection);

} // namespace keiko
