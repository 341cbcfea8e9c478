#pragma once

#include <filesystem>

namespace keiko::test {

/// A file of the repository, by its path from the root.
inline std::filesystem::path repository(const std::filesystem::path& relative) {
    return std::filesystem::path(KEIKO_SOURCE_DIR) / relative;
}

/// The collection of real CAD files that lies beside the project on some machines.
inline std::filesystem::path shared_model(const std::filesystem::path& name) {
    return repository("../shared/models") / name;
}

} // namespace keiko::test

/// Skips, aloud, a test that needs a real CAD file where the collection is absent.
#define KEIKO_NEEDS_SHARED_MODEL(name)                             \
    if (!std::filesystem::exists(keiko::test::shared_model(name))) \
    GTEST_SKIP() << name << " skipped: no ../shared/models beside the project"
