#include "keiko/files/model/model_serialization.h"

#include "keiko/base/error.h"
#include "keiko/files/model/byte_stream.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

/// A model with something in every list.
SurfaceModel full_model() {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {10, 0, 0}, {0, 20, 0});
    builder.polygon({{0.1, 0.1}, {0.9, 0.1}, {0.5, 0.8}});
    builder.instance(Affine::translate({1, 2, 3}) * Affine::scale(-2));
    SurfaceModel model = builder.build();
    model.source = "part.step";
    model.unit = "in";
    model.faces[0].name = "T\xc3\xbcr";
    model.faces[0].color = Rgb(0.1, 0.2, 0.3);
    model.faces[0].reversed = true;
    model.faces[0].line = 1234;
    model.edges.push_back({1e-3, 2, true});
    model.trim_curves[0].edge = 0;
    model.patches[0].map_u = {ParameterMap::Kind::circular, 0.5, 1.5};
    model.lost_faces.push_back({2, "lost", "an infinite plane"});
    model.irregular_patches.push_back({0, {1, 2, 3}, 0.5});
    model.repairs.push_back({1, RepairKind::gap_bridged, 3, 0.25, "words"});
    model.diagnostics.push_back({Severity::warning, "face 1", "remark"});
    return model;
}

std::string reason_for(const std::string& bytes) {
    try {
        deserialize(bytes, "model.bin");
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

/// The bytes with a right checksum over a changed payload.
std::string resealed(std::string bytes) {
    const std::uint64_t sum = checksum(std::string_view(bytes).substr(28));
    bytes.replace(12, 8, reinterpret_cast<const char*>(&sum), 8);
    return bytes;
}

TEST(ModelSerialization, RoundTripIsByteExact) {
    const std::string bytes = serialize(full_model());
    const SurfaceModel back = deserialize(bytes, "x");
    EXPECT_EQ(serialize(back), bytes);
    EXPECT_EQ(back.faces[0].name, "T\xc3\xbcr");
    EXPECT_EQ(back.faces[0].color, Rgb(0.1, 0.2, 0.3));
    EXPECT_EQ(back.faces[0].line, 1234u);
    EXPECT_EQ(back.patches[0].map_u, (ParameterMap{ParameterMap::Kind::circular, 0.5, 1.5}));
    EXPECT_EQ(back.instances[0].transform, full_model().instances[0].transform);
    EXPECT_TRUE(back.edges[0].degenerate);
    EXPECT_EQ(back.repairs[0].kind, RepairKind::gap_bridged);
}

TEST(ModelSerialization, AnEmptyModelSurvives) {
    const std::string bytes = serialize({});
    EXPECT_EQ(serialize(deserialize(bytes, "x")), bytes);
}

TEST(ModelSerialization, EveryCutIsAnError) {
    const std::string bytes = serialize(full_model());
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_FALSE(reason_for(bytes.substr(0, length)).empty()) << length;
    EXPECT_FALSE(reason_for(bytes + "x").empty());
}

TEST(ModelSerialization, EveryFlippedBitIsAnError) {
    const std::string bytes = serialize(full_model());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string bad = bytes;
        bad[i] = static_cast<char>(bad[i] ^ 4);
        EXPECT_FALSE(reason_for(bad).empty()) << i;
    }
}

TEST(ModelSerialization, DamageWithARightChecksumNeverCrashesAndNeverReturnsNonsense) {
    const std::string bytes = serialize(full_model());
    int refused = 0;
    for (std::size_t i = 28; i < bytes.size(); ++i)
        for (const int value : {0x00, 0x7f, 0xff}) {
            std::string bad = bytes;
            bad[i] = static_cast<char>(value);
            try {
                const SurfaceModel model = deserialize(resealed(bad), "x");
                for (std::uint32_t p = 0; p < model.patches.size(); ++p)
                    evaluate(model.patch(p), {0.5, 0.5}, 1);
            } catch (const Error&) {
                ++refused;
            }
        }
    EXPECT_GT(refused, 100);
}

TEST(ModelSerialization, AHugeCountIsRefusedBeforeAllocation) {
    std::string bytes = serialize({});
    bytes[28 + 24 + 7] = 0x7f; // top byte of the number of control points
    EXPECT_NE(reason_for(resealed(bytes)).find("a count beyond the end"), std::string::npos);
}

TEST(ModelSerialization, ErrorsNameFileAndReasonInOneLine) {
    EXPECT_EQ(reason_for("nonsense bytes"),
              "model.bin: not a sound serialised model: it does not begin as one");
    std::string bytes = serialize({});
    bytes[8] = 9;
    EXPECT_NE(reason_for(bytes).find("its version is 9, not 3"), std::string::npos);
}

TEST(ModelSerialization, NumbersThatAreNotFiniteAreRefused) {
    SurfaceModel model = full_model();
    model.control_points[0].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(reason_for(serialize(model)).find("control point 0"), std::string::npos);
    model = full_model();
    model.patches[0].first_point = 1;
    EXPECT_NE(reason_for(serialize(model)).find("patch 0"), std::string::npos);
}

} // namespace
} // namespace keiko
