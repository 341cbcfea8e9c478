#include "keiko/io/model_cache.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/io/load_model.h"
#include "keiko/io/model_serialization.h"

#include "tests/support/model_builder.h"
#include "tests/unit/io/temporary_folder.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

constexpr const char* step_text = "ISO-10303-21;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n";

/// A worker that answers with one plane and leaves a line for each time it was asked.
struct Cache : testing::Test {
    test::TemporaryFolder folder;
    LoadOptions options;

    Cache() {
        test::ModelBuilder builder;
        builder.plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        folder.file("answer", "model\n" + serialize(builder.build()));
        options.worker = worker("worker");
        options.cache = folder.path() / "kept" / "models";
    }
    std::filesystem::path worker(const std::string& name) const {
        return folder.script(name, "cd \"$(dirname \"$0\")\"; echo asked >> log; cat answer >&3");
    }
    std::size_t times_asked() const {
        if (!std::filesystem::exists(folder.path() / "log")) return 0;
        const std::string log = read_file(folder.path() / "log");
        return static_cast<std::size_t>(std::count(log.begin(), log.end(), '\n'));
    }
    std::vector<std::filesystem::path> entries() const {
        std::vector<std::filesystem::path> found;
        for (const auto& entry : std::filesystem::directory_iterator(options.cache))
            found.push_back(entry.path());
        return found;
    }
};

TEST_F(Cache, AFileIsReadOnceAndComesBackTheSame) {
    const auto path = folder.file("part.step", step_text);
    const SurfaceModel first = load_model(path, options), second = load_model(path, options);
    EXPECT_EQ(times_asked(), 1u);
    EXPECT_EQ(serialize(first), serialize(second));
    EXPECT_EQ(entries().size(), 1u);
}

TEST_F(Cache, WhateverChangesTheResultIsReadAnew) {
    load_model(folder.file("part.step", step_text), options);
    load_model(folder.file("part.step", std::string(step_text) + " "), options);
    EXPECT_EQ(times_asked(), 2u) << "other bytes";
    load_model(folder.file("other.step", step_text), options);
    EXPECT_EQ(times_asked(), 3u) << "another name";
    options.worker = worker("worker-of-another-time");
    std::filesystem::last_write_time(options.worker, std::filesystem::file_time_type::min() +
                                                         std::chrono::hours(24 * 365 * 100));
    load_model(folder.file("part.step", step_text), options);
    EXPECT_EQ(times_asked(), 4u) << "another reader";
    EXPECT_EQ(entries().size(), 4u);
}

TEST_F(Cache, FilesOfOneContentAndNameShareAnEntry) {
    load_model(folder.file("part.step", step_text), options);
    std::filesystem::create_directory(folder.path() / "elsewhere");
    const auto copy = folder.file("elsewhere/part.step", step_text);
    EXPECT_EQ(load_model(copy, options).source, copy.string());
    EXPECT_EQ(times_asked(), 1u);
}

TEST_F(Cache, AFileThatNamesOthersIsReadEachTimeForTheyMayChange) {
    const auto path =
        folder.file("car.step",
                    "ISO-10303-21;\nDATA;\n#1=DOCUMENT_FILE('wheel.stp','','',#2,'',$);\nENDSEC;\n"
                    "END-ISO-10303-21;\n");
    load_model(path, options);
    load_model(path, options);
    EXPECT_EQ(times_asked(), 2u);
    EXPECT_TRUE(entries().empty());
}

TEST_F(Cache, TheUnitIsChangedAfterwards) {
    const auto path = folder.file("part.step", step_text);
    load_model(path, options);
    options.unit = "m";
    EXPECT_EQ(load_model(path, options).control_points.back(), Vec4(1000, 1000, 0, 1));
    options.unit.clear();
    EXPECT_EQ(load_model(path, options).control_points.back(), Vec4(1, 1, 0, 1));
    EXPECT_EQ(times_asked(), 1u);
}

TEST_F(Cache, TheAxesAreTurnedAfterwards) {
    const auto path = folder.file("part.step", step_text);
    const auto placement = [&] { return load_model(path, options).instances.at(0).transform; };
    const Affine as_read = placement();
    options.axes = "y,z,x";
    EXPECT_NE(placement(), as_read);
    options.axes.clear();
    EXPECT_EQ(placement(), as_read);
    EXPECT_EQ(times_asked(), 1u);
}

TEST_F(Cache, ADamagedEntryIsReadAnewAndRewritten) {
    const auto path = folder.file("part.step", step_text);
    const std::string sound = serialize(load_model(path, options));
    for (const std::string& damage : {std::string(), std::string("rubbish"), sound.substr(0, 99)}) {
        std::ofstream(entries().front(), std::ios::binary) << damage;
        EXPECT_EQ(serialize(load_model(path, options)), sound);
    }
    EXPECT_EQ(times_asked(), 4u);
    EXPECT_EQ(serialize(load_model(path, options)), sound);
    EXPECT_EQ(times_asked(), 4u);
    EXPECT_EQ(entries().size(), 1u);
}

TEST_F(Cache, AFailureIsNotKept) {
    options.worker = folder.script("failing", "echo error too bad >&3");
    EXPECT_THROW(load_model(folder.file("part.step", step_text), options), Error);
    EXPECT_TRUE(entries().empty());
}

TEST_F(Cache, AFolderThatCannotBeIsAnError) {
    options.cache = folder.file("file", "kept");
    EXPECT_THROW(load_model(folder.file("part.step", step_text), options), Error);
    EXPECT_EQ(times_asked(), 0u);
}

TEST_F(Cache, AModelThatCannotBeKeptIsStillUsedWithAWarning) {
    const auto path = folder.file("part.step", step_text);
    load_model(path, options);
    const auto entry = entries().front();
    std::filesystem::remove(entry);
    std::filesystem::create_directory(entry);
    const SurfaceModel model = load_model(path, options);
    ASSERT_EQ(model.diagnostics.size(), 1u);
    EXPECT_EQ(model.diagnostics[0].severity, Severity::warning);
}

} // namespace
} // namespace keiko
