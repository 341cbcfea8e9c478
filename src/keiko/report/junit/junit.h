#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/report/markup/junit_suites.h"

#include <string>

namespace keiko {

/// Case of a check, for the file that it was made on.
JunitCase check_case(const std::string& source, const Check& check);

/// An inspection for build servers, as JUnit XML (the schema of the xUnit plugin of Jenkins,
/// junit-10.xsd): one suite, one case a seam and criterion. An exceeded limit is a failure. A value
/// that cannot be distinguished from its limit is an error, and so is a lost face. A check that
/// could not be judged is skipped. The XML holds no time, so that every run gives the same bytes.
std::string junit_xml(const Inspection& inspection);

} // namespace keiko
