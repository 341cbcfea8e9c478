// Geometry of files that OpenCASCADE does not translate.
#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/import/worker/load_model.h"

#include "tests/support/temporary_folder.h"
#include <BRepPrimAPI_MakeBox.hxx>
#include <STEPControl_Writer.hxx>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

namespace keiko {
namespace {

/// Number of the first entity of a kind, "#12".
std::string entity(const std::string& step, const std::string& kind) {
    const std::size_t at = step.find("= " + kind + "(");
    if (at == std::string::npos) return "no " + kind;
    const std::size_t begin = step.rfind('#', at);
    return step.substr(begin, step.find(' ', begin) - begin);
}

/// `text` with each name of a kind after '@' as its first entity: "@PLANE," becomes "#12,".
std::string with_numbers(std::string text, const std::string& step) {
    for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@')) {
        const std::size_t end = text.find_first_of(",)", at);
        text.replace(at, end - at, entity(step, text.substr(at + 1, end - at - 1)));
    }
    return text;
}

/// A box of six faces whose representation has one more item, #90000.
SurfaceModel box_with(const std::string& entities) {
    const test::TemporaryFolder folder;
    const auto path = folder.path() / "box.step";
    STEPControl_Writer writer;
    writer.Transfer(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), STEPControl_AsIs);
    EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    std::string step = read_file(path);
    const std::string added = with_numbers(entities, step);
    const std::size_t items = step.find("(#", step.find("= ADVANCED_BREP_SHAPE_REPRESENTATION("));
    step.insert(items + 1, "#90000,");
    step.insert(step.find("ENDSEC;\nEND-ISO"), added);
    return load_model(folder.file("edited.step", step));
}

constexpr const char* triangles =
    "#90010 = COORDINATES_LIST('',3,((0.,0.,0.),(9.,0.,0.),(0.,9.,0.)));\n"
    "#90011 = TRIANGULATED_FACE('',#90010,3,((0.,0.,1.)),$,(),((1,2,3)));\n"
    "#90012 = TRIANGULATED_FACE('',#90010,3,((0.,0.,1.)),@ADVANCED_FACE,(),((1,2,3)));\n"
    "#90013 = BLOCK('',@AXIS2_PLACEMENT_3D,1.,2.,3.);\n";

struct Item {
    const char *name, *kind, *text;
};

struct UnreadItems : testing::TestWithParam<Item> {};

TEST_P(UnreadItems, AreLost) {
    const SurfaceModel model = box_with(std::string(triangles) + GetParam().text);
    EXPECT_EQ(model.faces.size(), 6u);
    ASSERT_EQ(model.lost_faces.size(), 1u);
    const std::string& reason = model.lost_faces[0].reason;
    EXPECT_EQ(reason.find("#9000"), 0u) << reason;
    EXPECT_NE(reason.find(std::string(" of kind ") + GetParam().kind + " gave no face"),
              std::string::npos)
        << reason;
}

INSTANTIATE_TEST_SUITE_P(
    Each, UnreadItems,
    testing::Values(
        Item{"Shell", "TESSELLATED_SHELL", "#90000 = TESSELLATED_SHELL('',(#90011),$);\n"},
        Item{"Solid", "TESSELLATED_SOLID", "#90000 = TESSELLATED_SOLID('',(#90011),$);\n"},
        Item{"PartlyLinked", "TESSELLATED_SOLID",
             "#90000 = TESSELLATED_SOLID('',(#90011,#90012),$);\n"},
        Item{"Triangles", "TRIANGULATED_SURFACE_SET",
             "#90000 = TRIANGULATED_SURFACE_SET('',#90010,3,((0.,0.,1.)),(),((1,2,3)));\n"},
        Item{"SetOfTriangles", "TRIANGULATED_SURFACE_SET",
             "#90000 = TESSELLATED_GEOMETRIC_SET('',(#90001));\n#90001 = "
             "TRIANGULATED_SURFACE_SET('',#90010,3,((0.,0.,1.)),(),((1,2,3)));\n"},
        Item{"Strips", "TESSELLATED_SHELL",
             "#90000 = TESSELLATED_SHELL('',(#90001),$);\n#90001 = "
             "COMPLEX_TRIANGULATED_FACE('',#90010,3,((0.,0.,1.)),$,(),((1,2,3)),());\n"},
        Item{"Boolean", "BOOLEAN_RESULT", "#90000 = BOOLEAN_RESULT('',.UNION.,#90013,#90013);\n"},
        Item{"Block", "BLOCK", "#90000 = BLOCK('',@AXIS2_PLACEMENT_3D,1.,2.,3.);\n"},
        Item{"BareSurface", "PLANE", "#90000 = PLANE('',@AXIS2_PLACEMENT_3D);\n"},
        Item{"SetOfAnOffset", "OFFSET_SURFACE",
             "#90000 = GEOMETRIC_SET('',(#90001));\n#90001 = OFFSET_SURFACE('',#90002,1.,.F.);\n"
             "#90002 = B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#90003,#90004),(#90005,#90006)),"
             ".UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.);\n"
             "#90003 = CARTESIAN_POINT('',(0.,0.,0.));\n#90004 = CARTESIAN_POINT('',(0.,9.,0.));\n"
             "#90005 = CARTESIAN_POINT('',(9.,0.,0.));\n"
             "#90006 = CARTESIAN_POINT('',(9.,9.,0.));\n"},
        Item{"Copy", "SOLID_REPLICA",
             "#90000 = SOLID_REPLICA('',@MANIFOLD_SOLID_BREP,#90001);\n#90001 = "
             "CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',$,$,@CARTESIAN_POINT,1.,$);\n"},
        Item{"KindOfTheFuture", "VOXEL_SOLID", "#90000 = VOXEL_SOLID('',(1,2,3));\n"}),
    [](const auto& tested) { return std::string(tested.param.name); });

struct HarmlessItems : testing::TestWithParam<Item> {};

TEST_P(HarmlessItems, AreNotLost) {
    const SurfaceModel model = box_with(std::string(triangles) + GetParam().text);
    EXPECT_EQ(model.faces.size(), 6u);
    EXPECT_TRUE(model.lost_faces.empty()) << model.lost_faces[0].reason;
}

INSTANTIATE_TEST_SUITE_P(
    Each, HarmlessItems,
    testing::Values(
        Item{"TrianglesOfTheBox", "",
             "#90000 = TESSELLATED_SOLID('',(#90011),@MANIFOLD_SOLID_BREP);\n"},
        Item{"TrianglesOfAFace", "", "#90000 = TESSELLATED_SHELL('',(#90012),$);\n"},
        Item{"Point", "", "#90000 = CARTESIAN_POINT('',(0.,0.,0.));\n"},
        Item{"Axes", "", "#90000 = AXIS2_PLACEMENT_3D('',@CARTESIAN_POINT,$,$);\n"},
        Item{"Line", "", "#90000 = LINE('',@CARTESIAN_POINT,@VECTOR);\n"},
        Item{"UnknownCurve", "", "#90000 = CLOTHOIDAL_CURVE('',@AXIS2_PLACEMENT_3D);\n"},
        Item{"SetOfCurves", "",
             "#90000 = GEOMETRIC_CURVE_SET('',(#90001));\n"
             "#90001 = LINE('',@CARTESIAN_POINT,@VECTOR);\n"},
        Item{"TessellatedCurves", "", "#90000 = TESSELLATED_CURVE_SET('',#90010,((1,2,3)));\n"},
        Item{"SetOfTessellatedCurves", "",
             "#90000 = TESSELLATED_GEOMETRIC_SET('',(#90001));\n"
             "#90001 = TESSELLATED_CURVE_SET('',#90010,((1,2,3)));\n"},
        Item{"Annotation", "",
             "#90000 = TESSELLATED_ANNOTATION_OCCURRENCE('',(),@MANIFOLD_SOLID_BREP);\n"}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// An IGES file in mm of a flat square of 100 mm by 100 mm and of entities by their parameters,
/// such as "158,50.,0.,0.,0.". Entities have the numbers D3, D5, ...
std::string iges(const std::vector<std::string>& more, const std::string& scale = "1.") {
    std::vector<std::string> entities{
        "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,100.,0.,0.,0.,100.,0.,"
        "100.,100.,0.,0.,1.,0.,1."};
    entities.insert(entities.end(), more.begin(), more.end());
    char line[96];
    const auto row = [&](const std::string& text, int width, const std::string& end) {
        std::snprintf(line, sizeof line, "%-*s%s\n", width, text.c_str(), end.c_str());
        return std::string(line);
    };
    const auto section = [](char name, std::size_t number) {
        std::string digits = std::to_string(number);
        return name + std::string(7 - digits.size(), ' ') + digits;
    };
    const auto field = [](const std::string& text) {
        return std::string(8 - text.size(), ' ') + text;
    };
    std::string directory, parameters;
    std::size_t rows = 0;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const std::string type = entities[i].substr(0, 3), all = entities[i] + ";";
        const std::size_t first = rows + 1;
        for (std::size_t at = 0; at < all.size(); at += 64)
            parameters += row(all.substr(at, 64), 64,
                              field(std::to_string(2 * i + 1)) + section('P', ++rows));
        directory += row(field(type) + field(std::to_string(first)) +
                             "       0       0       0       0       0       000000000",
                         72, section('D', 2 * i + 1));
        directory +=
            row(field(type) + "       0       0" + field(std::to_string(rows + 1 - first)) +
                    "       0                               0",
                72, section('D', 2 * i + 2));
    }
    const std::string global =
        "1H,,1H;,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx," + scale + ",2,2HMM,1,.01,;";
    return row("x", 72, section('S', 1)) + row(global, 72, section('G', 1)) + directory +
           parameters +
           row("S      1G      1" + section('D', 2 * entities.size()) + section('P', rows), 72,
               section('T', 1));
}

SurfaceModel read_iges(const std::string& text) {
    const test::TemporaryFolder folder;
    return load_model(folder.file("model.igs", text));
}

struct UnreadBodies : testing::TestWithParam<std::vector<std::string>> {};

/// The last entity is the body, whatever it refers to.
TEST_P(UnreadBodies, AreLost) {
    const SurfaceModel model = read_iges(iges(GetParam()));
    EXPECT_EQ(model.faces.size(), 1u);
    ASSERT_EQ(model.lost_faces.size(), 1u);
    EXPECT_EQ(model.lost_faces[0].reason, "entity D" + std::to_string(1 + 2 * GetParam().size()) +
                                              " of type " + GetParam().back().substr(0, 3) +
                                              " gave no face");
}

INSTANTIATE_TEST_SUITE_P(
    Each, UnreadBodies,
    testing::Values(std::vector<std::string>{"150,10.,10.,5.,0.,0.,0.,1.,0.,0.,0.,0.,1."},
                    std::vector<std::string>{"154,10.,5.,0.,0.,0.,0.,0.,1."},
                    std::vector<std::string>{"158,50.,150.,0.,0."},
                    std::vector<std::string>{"100,0.,0.,0.,5.,0.,5.,0.", "164,3,9.,0.,0.,1."},
                    std::vector<std::string>{"158,50.,150.,0.,0.", "430,3"},
                    std::vector<std::string>{"158,50.,150.,0.,0.", "158,9.,0.,0.,0.",
                                             "180,3,-3,-5,1"}));

TEST(IgesModelSpace, IsScaledToTheWorld) {
    EXPECT_TRUE(read_iges(iges({})).diagnostics.empty());
    const SurfaceModel model = read_iges(iges({}, "0.1"));
    ASSERT_EQ(model.instances.size(), 1u);
    EXPECT_EQ(model.instances[0].transform, Affine::scale(1 / 0.1));
    ASSERT_EQ(model.diagnostics.size(), 1u);
    EXPECT_EQ(model.diagnostics[0].message,
              "its model space has a scale of 0.1: lengths are divided by it");
}

TEST(FilesWithoutFaces, NameWhatIsMissing) {
    const test::TemporaryFolder folder;
    const auto path = folder.path() / "box.step";
    STEPControl_Writer writer;
    writer.Transfer(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), STEPControl_AsIs);
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    std::string step = read_file(path);
    for (std::size_t at = step.find("= PLANE("); at != std::string::npos;
         at = step.find("= PLANE("))
        step.insert(at + 2, "UN");
    try {
        load_model(folder.file("edited.step", step));
        FAIL() << "it has no faces";
    } catch (const Error& e) {
        EXPECT_EQ(e.reason().find("no faces in the file: #"), 0u) << e.reason();
        EXPECT_NE(e.reason().find(" of kind UNPLANE; and 5 more"), std::string::npos) << e.reason();
    }
}

} // namespace
} // namespace keiko
