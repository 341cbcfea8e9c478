#include "keiko/import/worker/load_model.h"

#include "keiko/base/build_id.h"
#include "keiko/base/error.h"
#include "keiko/files/model/model_serialization.h"

#include "tests/support/model_builder.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>

namespace keiko {
namespace {

using namespace std::chrono_literals;

/// Looks like a whole STEP file to load_model; fake workers do not read it.
constexpr const char* step_text = "ISO-10303-21;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n";

struct LoadModel : testing::Test {
    test::TemporaryFolder folder;

    /// The one line of the error that loading gives, without the folder.
    std::string reason_for(const std::filesystem::path& path, const LoadOptions& options = {}) {
        try {
            load_model(path, options);
        } catch (const Error& e) {
            EXPECT_EQ(e.file(), path.string());
            EXPECT_EQ(e.reason().find('\n'), std::string::npos);
            return e.reason();
        }
        return "loaded";
    }
    std::string reason_with_worker(const std::string& script) {
        LoadOptions options;
        options.worker = folder.script("worker", script);
        options.timeout = 300ms;
        return reason_for(folder.file("part.step", step_text), options);
    }
};

TEST_F(LoadModel, FilesThatAreNone) {
    EXPECT_EQ(reason_for(folder.path() / "absent.step"), "no such file");
    EXPECT_EQ(reason_for(folder.path()), "is a directory, not a file");
    EXPECT_EQ(reason_for(folder.file("empty.step", "")), "the file is empty");
}

TEST_F(LoadModel, ContentCountsNotTheName) {
    const std::string expected =
        "not a model file (expected STEP, IGES, BREP, .bpt, teapot text or an OBJ cage)";
    EXPECT_EQ(reason_for(folder.file("text.step", "Dear customer,\nplease find enclosed\n")),
              expected);
    EXPECT_EQ(reason_for(folder.file("zeros.brep", std::string(5000, '\0'))), expected);
    const auto named_step = folder.file("patch.step", "1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 2\n");
    EXPECT_EQ(load_model(named_step).format, "BPT");
    const std::string cage = "# a cage\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    EXPECT_EQ(load_model(folder.file("cage.txt", cage)).format, "OBJ");
    EXPECT_EQ(reason_for(folder.file("empty.obj", "v 0 0 0\n")),
              "no faces in the file (an OBJ file needs v and f)");
    EXPECT_EQ(reason_for(folder.file("v.txt", "v is the fifth letter from the end\n")), expected);
}

TEST_F(LoadModel, ACageWhoseFirstVertexIsNoneIsACageAllTheSame) {
    EXPECT_EQ(reason_for(folder.file("a.obj", "v nan 0 0\n")), "not a finite number: \"nan\"");
    EXPECT_EQ(reason_for(folder.file("b.obj", "v -inf 0 0\n")), "not a finite number: \"-inf\"");
    EXPECT_EQ(reason_for(folder.file("c.obj", "v 0,5 1 2\n")), "not a finite number: \"0,5\"");
    EXPECT_EQ(reason_for(folder.file("d.obj", "v 1.5 2\n")), "a vertex needs x, y and z");
}

TEST_F(LoadModel, AFileThatShrinksToAPoint) {
    const auto path = folder.file("p.bpt", "1\n1 1\n7 0 0\n7 0 0\n7 0 0\n7 0 0\n");
    EXPECT_EQ(reason_for(path),
              "the points of each patch lie on one line or in one place: it is no surface");
}

TEST_F(LoadModel, FilesThatAreToBeSavedAnew) {
    EXPECT_EQ(reason_for(folder.file("a.step.gz", "\x1f\x8b\x08 and so on")),
              "is packed with gzip: unpack it first");
    EXPECT_EQ(reason_for(folder.file("a.stpz", "PK\x03\x04 and so on")),
              "is a zip archive: unpack it first");
    EXPECT_EQ(reason_for(folder.file("a.step", std::string("\xef\xbb\xbf") + step_text)),
              "begins with a byte order mark, which STEP does not allow: save it without");
}

TEST_F(LoadModel, FilesCutShort) {
    EXPECT_EQ(reason_for(folder.file("a.step", "ISO-10303-21;\nHEADER;\n")),
              "the STEP file is cut short: it has no end");
    EXPECT_EQ(reason_for(folder.file("a.brep", "DBRep_DrawableShape\n\nCASCADE Topology V1\n")),
              "the BREP file is cut short: it has no end");
    const std::string start = std::string(72, ' ') + "S0000001\n";
    EXPECT_EQ(reason_for(folder.file("a.igs", start)), "the IGES file is cut short: it has no end");
    const std::string padded = start + std::string(72, ' ') + "T0000001\n\032" + std::string(9, 0);
    EXPECT_NE(reason_for(folder.file("b.igs", padded)),
              "the IGES file is cut short: it has no end");
}

TEST_F(LoadModel, AStepFileOfNothing) {
    const std::string reason = reason_for(folder.file("a.step", step_text));
    EXPECT_NE(reason, "loaded");
}

TEST_F(LoadModel, AMissingWorkerIsTold) {
    LoadOptions options;
    options.worker = folder.path() / "none";
    EXPECT_EQ(reason_for(folder.file("a.step", step_text), options),
              "cannot be read: no reader at " + options.worker.string());
}

TEST_F(LoadModel, TheWorkerOfTheOptionsComesBeforeThatOfTheEnvironment) {
    LoadOptions options;
    options.worker = folder.path() / "mine";
    setenv("KEIKO_IMPORT", "/theirs", 1);
    EXPECT_EQ(worker_path(options), options.worker);
    EXPECT_EQ(worker_path({}), "/theirs");
    unsetenv("KEIKO_IMPORT");
    EXPECT_EQ(worker_path({}), binary_path().parent_path() / "keiko-import");
}

TEST_F(LoadModel, TheWorkerAnswersAProgramWhoseStandardStreamsAreClosed) {
    const int kept[] = {dup(0), dup(1), dup(2)};
    for (const int stream : {0, 1, 2}) close(stream);
    const std::string answer = reason_with_worker("echo complaint >&2; echo error answer >&3");
    const std::string complaint = reason_with_worker("echo complaint >&2");
    for (const int stream : {0, 1, 2}) {
        dup2(kept[stream], stream);
        close(kept[stream]);
    }
    EXPECT_EQ(answer, "answer");
    EXPECT_EQ(complaint, "the reader gave no model (exit code 0): complaint");
}

TEST_F(LoadModel, AWorkerThatCrashes) {
    EXPECT_EQ(reason_with_worker("kill -SEGV $$"), "the reader crashed on it: Segmentation fault");
    LoadOptions options;
    options.worker = folder.script("worker", "kill -SEGV $$");
    options.memory_limit = 1 << 20;
    EXPECT_EQ(reason_for(folder.file("part.step", step_text), options),
              "the reader crashed on it: Segmentation fault, perhaps for lack of memory");
}

TEST_F(LoadModel, AWorkerThatHangsIsKilledWithItsChildren) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(reason_with_worker("sleep 20"), "the reader did not finish within 0.3 s");
    EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
}

TEST_F(LoadModel, AWorkerThatFails) {
    EXPECT_EQ(reason_with_worker("echo some chatter >&2; echo libTK.so is missing >&2; exit 127"),
              "the reader gave no model (exit code 127): libTK.so is missing");
    EXPECT_EQ(reason_with_worker("exit 0"), "the reader gave no model (exit code 0)");
    EXPECT_EQ(reason_with_worker("echo error no faces in the file >&3; exit 1"),
              "no faces in the file");
    EXPECT_EQ(reason_with_worker("echo model >&3; echo rubbish >&3"),
              "not a sound serialised model: it does not begin as one");
}

TEST_F(LoadModel, AnAnswerOfManyPipeBuffersComesThroughWithItsProgress) {
    test::ModelBuilder builder;
    for (int i = 0; i < 5000; ++i) builder.plane(Vec3(i, 0, 0), {1, 0, 0}, {0, 1, 0});
    const std::string bytes = serialize(builder.build());
    folder.file("answer", "progress 0.25\nmodel\n" + bytes);
    LoadOptions options;
    options.worker = folder.script("worker", "echo noise; cat \"$(dirname \"$0\")/answer\" >&3");
    std::vector<double> fractions;
    Job job;
    job.progress = [&](const Progress& p) {
        EXPECT_EQ(p.stage, "import");
        fractions.push_back(p.fraction);
    };
    const auto path = folder.file("part.step", step_text);
    const SurfaceModel model = load_model(path, options, job);
    EXPECT_EQ(model.faces.size(), 5000u);
    EXPECT_EQ(model.source, path.string());
    EXPECT_EQ(fractions, (std::vector<double>{0, 0.25, 1}));
}

TEST_F(LoadModel, CancellingKillsTheWorker) {
    LoadOptions options;
    options.worker = folder.script("worker", "sleep 20");
    std::stop_source stop;
    Job job;
    job.stop = stop.get_token();
    std::jthread later([&] {
        std::this_thread::sleep_for(100ms);
        stop.request_stop();
    });
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW(load_model(folder.file("a.step", step_text), options, job), Cancelled);
    EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
}

TEST_F(LoadModel, TheUnitCanBeOverridden) {
    const auto path = folder.file("p.bpt", "1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 2\n");
    LoadOptions options;
    options.unit = "inch";
    const SurfaceModel model = load_model(path, options);
    EXPECT_EQ(evaluate(model.patch(0), {1, 1}, 0).position(), Vec3(25.4, 25.4, 50.8));
    EXPECT_EQ(model.unit, "inch");
    EXPECT_EQ(model.diagnostics.size(), 1u);
    options.unit = "furlong";
    EXPECT_EQ(reason_for(path, options), "unknown length unit \"furlong\"");
}

TEST_F(LoadModel, TheAxesOfTheFileAreTurnedIntoTheVehicleFrameExactly) {
    const auto path = folder.file("p.bpt", "1\n1 1\n0 0 0\n0 0.1 0\n1 0 0\n1 0.1 2\n");
    LoadOptions options;
    options.axes = "x,-z,y";
    const SurfaceModel model = load_model(path, options);
    const Affine& placed = model.instances.at(0).transform;
    EXPECT_EQ(placed.point({1, 0.1, 2}), Vec3(1, -2, 0.1));
    EXPECT_EQ(placed.determinant(), 1);
    EXPECT_EQ(model.control_points, load_model(path).control_points);
    ASSERT_EQ(model.diagnostics.size(), 1u);
    EXPECT_EQ(model.diagnostics[0].message,
              "turned: its x,-z,y point rearwards, to the right and up");
}

TEST_F(LoadModel, AxesThatAreNoRotationAreRefused) {
    const auto path = folder.file("p.bpt", "1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 2\n");
    LoadOptions options;
    for (const char* axes : {"x", "x,y", "x,y,y", "x,y,w", "x,y,z,", "x,y,z,x", "x,y,--z", ",,",
                             "x, y, z", "X,Y,Z", "xyz"}) {
        options.axes = axes;
        EXPECT_EQ(reason_for(path, options),
                  "axes \"" + options.axes +
                      "\": not three words of x, y, z, -x, -y and -z with each letter once");
    }
    options.axes = "x,z,y";
    EXPECT_EQ(reason_for(path, options),
              "axes \"x,z,y\": would mirror the body; one of them points the other way");
}

} // namespace
} // namespace keiko
