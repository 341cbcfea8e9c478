#include "keiko/workflow/painted_body.h"

#include "keiko/base/input_file.h"
#include "keiko/files/model/model_serialization.h"

#include "tests/support/model_builder.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(PaintedBody, AFileThatIsPlacedThriceIsReadOnce) {
    const test::TemporaryFolder folder;
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {10, 0, 0}, {0, 10, 0});
    folder.file("answer", "model\n" + serialize(builder.build()));
    LoadOptions options;
    options.worker =
        folder.script("worker", "cd \"$(dirname \"$0\")\"; echo asked >> log; cat answer >&3");
    const auto file = folder.file("wheel.step", "ISO-10303-21;\nEND-ISO-10303-21;\n");
    SceneSpec spec;
    for (const double x : {0.0, 100.0, 200.0}) {
        ModelSpec part{.file = file};
        part.transform.translation = Vec3(x, 0, 0);
        spec.models.push_back(part);
    }
    const PaintedBody body = read_body(spec, options, {});
    EXPECT_EQ(read_file(folder.path() / "log"), "asked\n");
    ASSERT_EQ(body.model.instances.size(), 3U);
    EXPECT_EQ(body.materials.size(), body.model.faces.size());
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(body.model.instances[i].transform.point(Vec3(0)),
                  Vec3(100.0 * static_cast<double>(i), 0, 0));
}

} // namespace
} // namespace keiko
