#pragma once

namespace keiko {

/// Share of a distance within which a light lies in a surface, as a panel flush with a ceiling. The
/// light is in front.
constexpr double flush = 1e-6;

} // namespace keiko
