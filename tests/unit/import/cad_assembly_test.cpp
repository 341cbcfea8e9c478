#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/units.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/import/worker/load_model.h"

#include "tests/support/temporary_folder.h"
#include <BRepPrimAPI_MakeBox.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko::cad {
namespace {

using DocumentHandle = opencascade::handle<TDocStd_Document>;

TopLoc_Location moved(double x, double y, double z) {
    gp_Trsf move;
    move.SetTranslation(gp_Vec(x, y, z));
    return TopLoc_Location(move);
}

TopLoc_Location turned_about_z(double angle) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), angle);
    return TopLoc_Location(turn);
}

void name(const TDF_Label& label, const char* text) {
    TDataStd_Name::Set(label, text);
}

/// A car with two axles; an axle with two wheels, the second turned half around. The first face of
/// a wheel is red and on the layer "tread".
struct Car {
    DocumentHandle document;

    Car() {
        XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
        const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
        const TopoDS_Shape solid = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 30, 10, 30).Shape();
        const TDF_Label wheel = shapes->AddShape(solid, false);
        name(wheel, "wheel");
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(solid, TopAbs_FACE, faces);
        const TDF_Label tread = shapes->AddSubShape(wheel, faces(1));
        XCAFDoc_DocumentTool::ColorTool(document->Main())
            ->SetColor(tread, Quantity_Color(1, 0, 0, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
        XCAFDoc_DocumentTool::LayerTool(document->Main())->SetLayer(tread, "tread");
        const TDF_Label axle = shapes->NewShape();
        name(axle, "axle");
        name(shapes->AddComponent(axle, wheel, moved(0, 100, 0)), "left");
        name(shapes->AddComponent(axle, wheel, turned_about_z(M_PI) * moved(0, 100, 0)), "right");
        const TDF_Label car = shapes->NewShape();
        name(car, "car");
        name(shapes->AddComponent(car, axle, moved(1000, 0, 0)), "front axle");
        name(shapes->AddComponent(car, axle, moved(-1000, 0, 0)), "rear axle");
        shapes->UpdateAssemblies();
    }
};

std::vector<Vec3> origins(const SurfaceModel& model) {
    std::vector<Vec3> found;
    for (const Instance& instance : model.instances)
        found.push_back(instance.transform.point(Vec3(0)));
    return found;
}

std::size_t near(const std::vector<Vec3>& points, const Vec3& wanted) {
    return static_cast<std::size_t>(std::count_if(
        points.begin(), points.end(), [&](const Vec3& p) { return (p - wanted).length() < 1e-6; }));
}

bool near(const Affine& a, const Affine& b) {
    const Vec3 places[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return std::all_of(std::begin(places), std::end(places),
                       [&](const Vec3& p) { return (a.point(p) - b.point(p)).length() < 1e-6; });
}

struct CadAssembly : testing::TestWithParam<const char*> {
    test::TemporaryFolder folder;

    SurfaceModel car(const char* schema) {
        const auto path = folder.path() / "car.step";
        STEPCAFControl_Writer writer;
        Interface_Static::SetCVal("write.step.schema", schema);
        writer.SetColorMode(true);
        writer.SetNameMode(true);
        writer.SetLayerMode(true);
        EXPECT_TRUE(writer.Transfer(Car().document));
        EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
        return load_model(path);
    }
};

TEST_P(CadAssembly, KeepsNestedPlacementsNamesColoursAndLayers) {
    const SurfaceModel model = car(GetParam());
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].name, "wheel");
    EXPECT_EQ(model.faces.size(), 6u) << "geometry is stored once";
    ASSERT_EQ(model.instances.size(), 4u);
    for (const double x : {1000.0, -1000.0})
        for (const double y : {100.0, -100.0}) EXPECT_EQ(near(origins(model), {x, y, 0}), 1u);
    EXPECT_NEAR(material_bounds(model).lower.x, -1030, 1e-6) << "the turned wheels";
    std::size_t red = 0, tread = 0;
    for (const Face& face : model.faces) {
        red += face.color && face.color->r > 0.99 && face.color->g < 0.01;
        tread += face.layer == "tread";
    }
    EXPECT_EQ(red, 1u);
    EXPECT_EQ(tread, 1u);
}

/// The car with its wheel shown through mapped items alone: mirrored across y = 5, as it is, or
/// both.
std::string with_mapped_wheel(std::string step, bool as_it_is) {
    const std::string kind = "ADVANCED_BREP_SHAPE_REPRESENTATION";
    const std::size_t at = step.find(kind), open = step.find('(', at), end = step.find(';', at);
    const std::string body = step.substr(open, end - open);
    const std::string context = body.substr(body.rfind('#'));
    const std::string items = as_it_is ? "#900006,#900007" : "#900006";
    step.replace(at, end - at, "SHAPE_REPRESENTATION('',(#900001," + items + ")," + context);
    const std::string added =
        "#900000=" + kind + body + ";\n#900001=AXIS2_PLACEMENT_3D('',#900002,$,$);\n" +
        "#900002=CARTESIAN_POINT('',(0.,0.,0.));\n#900003=DIRECTION('',(0.,-1.,0.));\n" +
        "#900004=CARTESIAN_POINT('',(0.,10.,0.));\n#900005=REPRESENTATION_MAP(#900001,#900000);\n" +
        "#900006=MAPPED_ITEM('',#900005,#900008);\n#900007=MAPPED_ITEM('',#900005,#900009);\n" +
        "#900008=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',$,$,#900003,#900004,$,$);\n" +
        "#900009=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',$,$,$,#900002,1.,$);\n";
    return step.insert(step.rfind("ENDSEC;"), added);
}

TEST_P(CadAssembly, PlacesMirroredItemsOfItsProducts) {
    const SurfaceModel plain = car(GetParam());
    const std::string text = read_file(folder.path() / "car.step");
    const Affine mirror =
        Affine::translate({0, 10, 0}) * Affine{{Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1)}};
    for (const bool as_it_is : {false, true}) {
        const SurfaceModel model =
            load_model(folder.file("mapped.step", with_mapped_wheel(text, as_it_is)));
        EXPECT_EQ(model.parts.size(), 1u) << "the geometry is held once";
        EXPECT_EQ(model.faces.size(), plain.faces.size());
        std::vector<Affine> wanted;
        for (const Instance& instance : plain.instances) {
            wanted.push_back(instance.transform * mirror);
            if (as_it_is) wanted.push_back(instance.transform);
        }
        ASSERT_EQ(model.instances.size(), wanted.size());
        for (const Affine& place : wanted)
            EXPECT_EQ(std::count_if(model.instances.begin(), model.instances.end(),
                                    [&](const Instance& instance) {
                                        return near(instance.transform, place);
                                    }),
                      1);
        for (const Diagnostic& d : model.diagnostics)
            EXPECT_NE(d.severity, Severity::warning) << d.message;
    }
}

INSTANTIATE_TEST_SUITE_P(Step, CadAssembly, testing::Values("AP203", "AP214IS", "AP242DIS"));

TEST(CadAssemblyWithoutNames, CallsOccurrencesAsTheirProduct) {
    const test::TemporaryFolder folder;
    DocumentHandle document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label nut =
        shapes->AddShape(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 3, 1, 3).Shape(), false);
    name(nut, "nut");
    const TDF_Label plate = shapes->NewShape();
    name(plate, "plate");
    for (const double x : {0.0, 100.0})
        shapes->AddComponent(plate, nut, moved(x, 0, 0)).ForgetAttribute(TDataStd_Name::GetID());
    shapes->UpdateAssemblies();
    const auto path = folder.path() / "plate.step";
    STEPCAFControl_Writer writer;
    ASSERT_TRUE(writer.Transfer(document));
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    const SurfaceModel model = load_model(path);
    ASSERT_EQ(model.instances.size(), 2u);
    EXPECT_EQ(model.instances[0].name, "nut");
    EXPECT_EQ(model.instances[1].name, "nut");
}

/// An assembly whose parts are files of their own, beside it.
TEST(CadAssemblyOfFiles, ReadsThemOrSaysWhichAreMissing) {
    const test::TemporaryFolder folder;
    const auto path = folder.path() / "car.step";
    STEPCAFControl_Writer writer;
    ASSERT_TRUE(writer.Transfer(Car().document, STEPControl_AsIs, "part-"));
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    const SurfaceModel whole = load_model(path);
    EXPECT_EQ(whole.faces.size(), 6u);
    EXPECT_EQ(whole.instances.size(), 4u);
    ASSERT_TRUE(std::filesystem::remove(folder.path() / "part-wheel.stp"));
    try {
        load_model(path);
        ADD_FAILURE() << "nothing is left to load";
    } catch (const Error& e) {
        EXPECT_EQ(e.reason(),
                  "no faces in the file; parts are in files that cannot be read: "
                  "\"part-wheel.stp\"");
    }
}

/// A length unit as files name it.
struct Unit {
    const char *iges, *step;
    double millimetres;
};

struct CadUnits : testing::TestWithParam<Unit> {
    test::TemporaryFolder folder;
    TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();

    void expect_box(const std::filesystem::path& path, double scale) {
        const SurfaceModel model = load_model(path);
        EXPECT_LT((material_bounds(model).extent() - Vec3(10, 20, 30) * scale).length(),
                  1e-7 * scale);
        EXPECT_EQ(model.faces.size(), 6u);
        EXPECT_EQ(millimetres_per(model.unit), GetParam().millimetres) << model.unit;
    }
};

/// A STEP file in mm whose numbers are then said to be of another unit.
TEST_P(CadUnits, OfAStepFileBecomeMillimetres) {
    const auto path = folder.path() / "box.step";
    STEPControl_Writer writer;
    writer.Transfer(box, STEPControl_AsIs);
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    std::string text = read_file(path);
    constexpr std::string_view millimetre =
        "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )";
    const std::size_t at = text.find(millimetre);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, millimetre.size(), GetParam().step);
    expect_box(folder.file("other.step", text), GetParam().millimetres);
}

TEST_P(CadUnits, OfAnIgesFileBecomeMillimetres) {
    const auto path = folder.path() / "box.igs";
    IGESControl_Writer writer(GetParam().iges, 0);
    writer.AddShape(box);
    writer.ComputeModel();
    ASSERT_TRUE(writer.Write(path.c_str()));
    expect_box(path, 1);
}

constexpr const char* inch =
    "( CONVERSION_BASED_UNIT('INCH',#90001) LENGTH_UNIT() NAMED_UNIT(#90002) );\n"
    "#90001=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#90003);\n"
    "#90002=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
    "#90003=( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )";
constexpr const char* foot =
    "( CONVERSION_BASED_UNIT('FOOT',#90001) LENGTH_UNIT() NAMED_UNIT(#90002) );\n"
    "#90001=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(304.8),#90003);\n"
    "#90002=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
    "#90003=( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )";

INSTANTIATE_TEST_SUITE_P(
    Each, CadUnits,
    testing::Values(Unit{"MM", "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )", 1},
                    Unit{"CM", "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.CENTI.,.METRE.) )", 10},
                    Unit{"M", "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.) )", 1000},
                    Unit{"INCH", inch, 25.4}, Unit{"FT", foot, 304.8}),
    [](const auto& tested) { return std::string(tested.param.iges); });

} // namespace
} // namespace keiko::cad
