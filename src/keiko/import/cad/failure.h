#pragma once

#include <string>

namespace keiko::cad {

/// The reason of the exception being handled, one line. Lack of memory is thrown on: it is not
/// the fault of one face.
std::string current_failure();

} // namespace keiko::cad
