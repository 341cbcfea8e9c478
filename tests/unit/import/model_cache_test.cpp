#include "keiko/import/worker/model_cache.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/files/model/model_serialization.h"
#include "keiko/import/worker/load_model.h"

#include "tests/support/abandoned_name.h"
#include "tests/support/model_builder.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <future>

namespace keiko {
namespace {

constexpr const char* step_text = "ISO-10303-21;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n";

/// A worker that answers with one plane and leaves a line for each time it was asked.
struct Cache : testing::Test {
    test::TemporaryFolder folder;
    LoadOptions options;

    Cache() {
        answer_with(1);
        options.worker = worker("worker");
        options.cache = folder.path() / "kept" / "models";
    }
    /// Changes the answer of the worker.
    void answer_with(int planes) const {
        test::ModelBuilder builder;
        for (int i = 0; i < planes; ++i)
            builder.plane({0, 0, static_cast<double>(i)}, {1, 0, 0}, {0, 1, 0});
        folder.file("answer", "model\n" + serialize(builder.build()));
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
    /// The entry that was not there before.
    std::filesystem::path new_entry(const std::vector<std::filesystem::path>& before) const {
        for (const auto& entry : entries())
            if (std::find(before.begin(), before.end(), entry) == before.end()) return entry;
        return {};
    }
    /// Entry of a model that is read now, made to look last used `hours_ago`.
    std::filesystem::path entry_used(int hours_ago, const std::filesystem::path& file) const {
        const auto before =
            std::filesystem::exists(options.cache) ? entries() : decltype(entries()){};
        load_model(file, options);
        const auto entry = new_entry(before);
        using Clock = std::filesystem::file_time_type::clock;
        std::filesystem::last_write_time(entry, Clock::now() - std::chrono::hours(hours_ago));
        return entry;
    }
    std::string reason_of_loading(const std::filesystem::path& path) const {
        try {
            load_model(path, options);
        } catch (const Error& error) {
            return error.reason();
        }
        return "no error";
    }
};

mode_t mode_of(const std::filesystem::path& path) {
    struct stat status {};
    EXPECT_EQ(lstat(path.c_str(), &status), 0);
    return status.st_mode & 07777;
}

constexpr uid_t somebody_else = 65534;

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

TEST_F(Cache, ALinkInThePlaceOfAnEntryIsReplacedNotFollowed) {
    const auto path = folder.file("part.step", step_text);
    const auto victim = folder.file("victim", "precious");
    load_model(path, options);
    const auto entry = entries().front();
    std::filesystem::remove(entry);
    std::filesystem::create_symlink(victim, entry);
    EXPECT_TRUE(load_model(path, options).diagnostics.empty());
    EXPECT_EQ(read_file(victim), "precious");
    EXPECT_FALSE(std::filesystem::is_symlink(entry));
    load_model(path, options);
    EXPECT_EQ(times_asked(), 2u);
}

TEST_F(Cache, AnEntryThatTheUserAloneHasNotWrittenIsNone) {
    const auto path = folder.file("part.step", step_text);
    load_model(path, options);
    const auto entry = entries().front();
    std::filesystem::copy_file(entry, folder.path() / "elsewhere");
    std::filesystem::remove(entry);
    std::filesystem::create_symlink(folder.path() / "elsewhere", entry);
    load_model(path, options);
    EXPECT_EQ(times_asked(), 2u) << "a link";
    ASSERT_EQ(chmod(entry.c_str(), 0666), 0);
    load_model(path, options);
    EXPECT_EQ(times_asked(), 3u) << "writable by others";
    if (geteuid() != 0) return; // only root may give a file away
    ASSERT_EQ(chown(entry.c_str(), somebody_else, somebody_else), 0);
    load_model(path, options);
    EXPECT_EQ(times_asked(), 4u) << "of another user";
}

TEST_F(Cache, APipeInThePlaceOfAnEntryIsReplacedWithoutAWait) {
    const auto path = folder.file("part.step", step_text);
    load_model(path, options);
    const auto entry = entries().front();
    std::filesystem::remove(entry);
    ASSERT_EQ(mkfifo(entry.c_str(), 0600), 0);
    EXPECT_TRUE(load_model(path, options).diagnostics.empty());
    EXPECT_TRUE(std::filesystem::is_regular_file(entry));
}

TEST_F(Cache, AnEntryUnderAnotherKeyIsNone) {
    const auto one = folder.file("one.step", step_text), two = folder.file("two.step", step_text);
    load_model(one, options);
    const auto of_one = entries();
    answer_with(2);
    load_model(two, options);
    std::filesystem::copy_file(of_one.front(), new_entry(of_one),
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_EQ(load_model(two, options).faces.size(), 2u);
    EXPECT_EQ(times_asked(), 3u);
}

TEST_F(Cache, AFileThatChangesWhileItIsReadIsAnErrorAndNotKept) {
    options.worker = folder.script("slow", "cat \"$(dirname \"$0\")/answer\" >&3; echo >> \"$1\"");
    EXPECT_EQ(reason_of_loading(folder.file("part.step", step_text)),
              "the file changed while it was read");
    EXPECT_TRUE(entries().empty());
}

TEST_F(Cache, AFileThatWasAnotherWhileItWasReadIsNotKept) {
    options.worker =
        folder.script("slow",
                      "cp \"$1\" \"$0.kept\"; echo other > \"$1\"; "
                      "cat \"$(dirname \"$0\")/answer\" >&3; cat \"$0.kept\" > \"$1\"");
    EXPECT_EQ(load_model(folder.file("part.step", step_text), options).faces.size(), 1u);
    EXPECT_TRUE(entries().empty());
}

TEST_F(Cache, OnlyTheUserMayReadIt) {
    const mode_t before = umask(0);
    load_model(folder.file("part.step", step_text), options);
    umask(before);
    EXPECT_EQ(mode_of(options.cache), 0700u);
    EXPECT_EQ(mode_of(entries().front()), 0600u);
}

TEST_F(Cache, AFolderThatOthersMayWriteIsAnError) {
    const auto path = folder.file("part.step", step_text);
    load_model(path, options);
    ASSERT_EQ(chmod(options.cache.c_str(), 0777), 0);
    EXPECT_EQ(reason_of_loading(path), "others may write in the folder; chmod go-w ends that");
    if (geteuid() != 0) return; // only root may give a folder away
    ASSERT_EQ(chmod(options.cache.c_str(), 0700), 0);
    ASSERT_EQ(chown(options.cache.c_str(), somebody_else, somebody_else), 0);
    EXPECT_EQ(reason_of_loading(path), "the folder belongs to another user");
}

TEST_F(Cache, TheLeastRecentlyUsedModelsAreRemovedBeyondTheLimit) {
    const auto one = folder.file("one.step", step_text), two = folder.file("two.step", step_text),
               three = folder.file("three.step", step_text);
    const auto of_one = entry_used(3, one), of_two = entry_used(2, two);
    options.cache_limit = 5 * std::filesystem::file_size(of_one) / 2;
    const auto notes = options.cache / "notes.txt";
    std::ofstream(notes) << "not Keiko's";
    load_model(one, options); // used now
    EXPECT_EQ(times_asked(), 2u);
    load_model(three, options);
    EXPECT_TRUE(std::filesystem::exists(of_one));
    EXPECT_FALSE(std::filesystem::exists(of_two));
    EXPECT_EQ(read_file(notes), "not Keiko's");
    load_model(one, options), load_model(three, options);
    EXPECT_EQ(times_asked(), 3u);
}

TEST_F(Cache, AModelLargerThanTheLimitIsNotKeptAndRemovesNone) {
    const auto kept = entry_used(1, folder.file("one.step", step_text));
    options.cache_limit = std::filesystem::file_size(kept) + 10;
    answer_with(100);
    const SurfaceModel model = load_model(folder.file("large.step", step_text), options);
    EXPECT_EQ(model.faces.size(), 100u);
    ASSERT_EQ(model.diagnostics.size(), 1u);
    EXPECT_NE(model.diagnostics[0].message.find("larger than the"), std::string::npos);
    EXPECT_EQ(entries(), std::vector{kept});
}

TEST_F(Cache, WhatKilledWritersLeftIsRemoved) {
    load_model(folder.file("one.step", step_text), options);
    std::ofstream(options.cache / test::abandoned_name()) << "half";
    load_model(folder.file("two.step", step_text), options);
    EXPECT_EQ(entries().size(), 2u);
}

TEST_F(Cache, ThoseWhoFillItAtOnceDoNotMeet) {
    const auto path = folder.file("part.step", step_text);
    const auto load = [&] { return load_model(path, options); };
    for (int turn = 0; turn < 5; ++turn) {
        std::vector<std::future<SurfaceModel>> loads;
        for (int i = 0; i < 4; ++i) loads.push_back(std::async(std::launch::async, load));
        for (auto& model : loads) EXPECT_TRUE(model.get().diagnostics.empty());
        ASSERT_EQ(entries().size(), 1u);
        std::filesystem::remove(entries().front());
    }
}

} // namespace
} // namespace keiko
