#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <string>

namespace keiko::test {

/// The name of a test whose parameter is a file's name.
inline std::string file_test_name(const testing::TestParamInfo<const char*>& tested) {
    std::string name = tested.param;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

} // namespace keiko::test
