#pragma once

#include "shape_pool.h"

namespace keiko::fixtures {

/// A fact that holds by construction, beside what evaluating the finished surfaces finds.
struct GroundTruth {
    std::string what;
    std::string unit;
    double promised;
    double measured;
    double tolerance;
};

/// A STEP model of surfaces/ with what is known about it.
struct Fixture {
    std::string file;
    std::vector<NamedFace> faces;
    std::vector<GroundTruth> truths;
};

/// A Bezier patch file of surfaces/ (.bpt: the patch count; for each patch its two degrees, then
/// the control points, v running fastest).
struct BptFixture {
    std::string file;
    std::vector<Net> patches;
    std::vector<GroundTruth> truths;
};

/// The cage of a subdivision surface in surfaces/ (.obj).
struct CageFixture {
    struct Face {
        std::string group;
        std::vector<int> corners; ///< vertices, from 0
    };

    std::string file;
    std::vector<gp_XYZ> vertices;
    std::vector<Face> faces;
    std::vector<std::string> tags; ///< after the "t"
    std::vector<GroundTruth> truths;
};

/// A text file of surfaces/, line by line.
struct TextFixture {
    std::string file;
    std::vector<std::string> lines;
    std::vector<GroundTruth> truths;
};

/// A file of bytes of surfaces/.
struct RawFixture {
    std::string file;
    std::string bytes;
    std::vector<GroundTruth> truths;
};

/// Prints the truths of a file. Throws std::runtime_error if a measurement is off.
void report(const std::string& file, const std::vector<GroundTruth>& truths);

} // namespace keiko::fixtures
