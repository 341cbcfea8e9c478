// Owns no code: CMake needs a source to precompile gtest for, which all test programs reuse.
