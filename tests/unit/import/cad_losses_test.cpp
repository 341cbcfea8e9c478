#include "keiko/base/input_file.h"
#include "keiko/import/worker/load_model.h"

#include "tests/support/temporary_folder.h"
#include "tests/unit/import/converted_shape.h"
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>

namespace keiko::cad {
namespace {

TopLoc_Location moved(double x) {
    gp_Trsf move;
    move.SetTranslation(gp_Vec(x, 0, 0));
    return TopLoc_Location(move);
}

TopoDS_Shape box() {
    return BRepPrimAPI_MakeBox(10, 20, 30).Shape();
}

/// Seven faces; a round hole in two of them is one edge with one vertex.
TopoDS_Shape bored_box() {
    const gp_Ax2 axis(gp_Pnt(5, 10, -1), gp_Dir(0, 0, 1));
    return BRepAlgoAPI_Cut(box(), BRepPrimAPI_MakeCylinder(axis, 3, 40).Shape()).Shape();
}

/// Number of the first entity of a kind, "#12"; `nth` counts from 0.
std::string entity(const std::string& step, const std::string& kind, int nth = 0) {
    std::size_t at = 0;
    for (int i = 0; i <= nth; ++i) at = step.find("= " + kind + "(", i == 0 ? 0 : at + 1);
    if (at == std::string::npos) return "no " + kind;
    const std::size_t begin = step.rfind('#', at);
    return step.substr(begin, step.find(' ', begin) - begin);
}

/// Gives an entity a name that no schema has.
void make_unknown(std::string& step, const std::string& number) {
    const std::size_t at = step.find("\n" + number + " = ");
    ASSERT_NE(at, std::string::npos) << number;
    step.insert(at + number.size() + 4, "UN");
}

void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

struct CadLosses : testing::Test {
    test::TemporaryFolder folder;

    using Edit = std::function<void(std::string&)>;

    SurfaceModel edited(const std::filesystem::path& path, const Edit& edit) {
        std::string text = read_file(path);
        edit(text);
        return load_model(folder.file("edited" + path.extension().string(), text));
    }

    /// Two bodies side by side, so that something is left of each edited file.
    SurfaceModel step(const TopoDS_Shape& first, const Edit& edit) {
        const auto path = folder.path() / "shapes.step";
        STEPControl_Writer writer;
        writer.Transfer(first, STEPControl_AsIs);
        writer.Transfer(BRepPrimAPI_MakeBox(gp_Pnt(100, 0, 0), 10, 20, 30).Shape(),
                        STEPControl_AsIs);
        EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
        return edited(path, edit);
    }

    /// Two places of one box; each is a component of an assembly.
    SurfaceModel assembly(const Edit& edit) {
        opencascade::handle<TDocStd_Document> document;
        XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
        const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
        const TDF_Label part = shapes->AddShape(box(), false), whole = shapes->NewShape();
        shapes->AddComponent(whole, part, moved(0));
        shapes->AddComponent(whole, part, moved(100));
        shapes->UpdateAssemblies();
        const auto path = folder.path() / "assembly.step";
        STEPCAFControl_Writer writer;
        EXPECT_TRUE(writer.Transfer(document));
        EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
        return edited(path, edit);
    }
};

void expect(const SurfaceModel& model, std::size_t faces, std::size_t lost,
            const std::string& reason) {
    EXPECT_EQ(model.faces.size(), faces);
    ASSERT_EQ(model.lost_faces.size(), lost);
    for (const LostFace& face : model.lost_faces) {
        EXPECT_NE(face.reason.find(reason), std::string::npos) << face.reason;
        EXPECT_GT(face.id, 0u);
        EXPECT_LE(face.id, faces + lost);
    }
}

void leave(std::string&) {}

TEST_F(CadLosses, NoneInWholeFiles) {
    expect(step(bored_box(), leave), 13, 0, "");
    expect(assembly(leave), 6, 0, "");
}

TEST_F(CadLosses, AFaceWhoseSurfaceIsUnknown) {
    std::string number;
    const SurfaceModel model = step(box(), [&](std::string& text) {
        number = entity(text, "ADVANCED_FACE");
        make_unknown(text, entity(text, "PLANE"));
    });
    expect(model, 11, 1, number + " in line ");
}

/// A face on the offset surface of two planes that meet at an angle, with this many knots there.
TopoDS_Shape offset_of_kink(double slope, int knots) {
    const std::array<double, 7> x{-100, -66, -33, 0, 33, 66, 100};
    TColgp_Array2OfPnt poles(1, knots + 4, 1, 2);
    for (int i = 1; i <= knots + 4; ++i)
        for (int j = 1; j <= 2; ++j) {
            const double at = x[static_cast<std::size_t>(knots < 3 && i > 3 ? i : i - 1)];
            poles(i, j) = gp_Pnt(at, j == 1 ? -50 : 50, std::max(at, 0.0) * slope);
        }
    TColStd_Array1OfReal u(1, 3), v(1, 2);
    TColStd_Array1OfInteger times_u(1, 3), times_v(1, 2);
    for (int i = 1; i <= 3; ++i) u(i) = i, times_u(i) = i == 2 ? knots : 4;
    for (int i = 1; i <= 2; ++i) v(i) = i, times_v(i) = 2;
    const opencascade::handle<Geom_Surface> base =
        new Geom_BSplineSurface(poles, u, v, times_u, times_v, 3, 1);
    const opencascade::handle<Geom_Surface> offset = new Geom_OffsetSurface(base, 5, true);
    return BRepBuilderAPI_MakeFace(offset, 1e-6).Shape();
}

/// OpenCASCADE takes knots out of such a base, whose corner is then up to a millimetre off.
TEST_F(CadLosses, AnOffsetSurfaceOfAKinkThatTheReaderSmooths) {
    expect(step(offset_of_kink(0.05, 3), leave), 6, 1, "smoothed a kink of its offset surface #");
    expect(step(offset_of_kink(0, 3), leave), 7, 0, "");
    expect(step(offset_of_kink(0.05, 2), leave), 7, 0, "");
}

TEST_F(CadLosses, AFaceWhoseKnotsDoNotAddUp) {
    const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(bored_box()).Shape();
    const SurfaceModel model = step(splines, [](std::string& text) {
        const std::size_t at = text.find("= B_SPLINE_SURFACE_WITH_KNOTS(");
        ASSERT_NE(at, std::string::npos);
        const std::size_t list = text.find("(2,2)", at);
        ASSERT_NE(list, std::string::npos);
        text.replace(list, 5, "(2,9)");
    });
    expect(model, 12, 1, " gave no face");
}

/// One of two shells of sheets: OpenCASCADE itself crashes where that of a solid is unknown.
TEST_F(CadLosses, FacesOfAnUnknownShell) {
    TopoDS_Compound sheets;
    BRep_Builder().MakeCompound(sheets);
    for (const double x : {0.0, 50.0}) {
        TopoDS_Shell shell;
        BRep_Builder().MakeShell(shell);
        BRep_Builder().Add(shell, TopExp_Explorer(box().Moved(moved(x)), TopAbs_FACE).Current());
        BRep_Builder().Add(sheets, shell);
    }
    const SurfaceModel model =
        step(sheets, [](std::string& text) { make_unknown(text, entity(text, "OPEN_SHELL")); });
    expect(model, 7, 1, " gave no face");
}

TEST_F(CadLosses, FacesOfAnUnknownSolidOrRepresentation) {
    for (const char* kind : {"MANIFOLD_SOLID_BREP", "ADVANCED_BREP_SHAPE_REPRESENTATION"})
        expect(step(box(), [&](std::string& text) { make_unknown(text, entity(text, kind)); }), 6,
               6, " gave no face");
}

TEST_F(CadLosses, AnEmptyShell) {
    std::string number;
    const SurfaceModel model = step(box(), [&](std::string& text) {
        number = entity(text, "CLOSED_SHELL");
        const std::size_t list = text.find("(#", text.find("= CLOSED_SHELL("));
        text.erase(list + 1, text.find(')', list) - list - 1);
    });
    expect(model, 6, 1, number + " in line ");
}

TEST_F(CadLosses, NoFaceThatNoShapeRefersTo) {
    const SurfaceModel model = step(box(), [](std::string& text) {
        replace(text, "ENDSEC;\nEND-ISO",
                "#90000 = ADVANCED_FACE('',(),#90001,.T.);\n#90001 = UNPLANE('',$);\n"
                "ENDSEC;\nEND-ISO");
    });
    expect(model, 12, 0, "");
    ASSERT_FALSE(model.diagnostics.empty());
    EXPECT_EQ(model.diagnostics[0].message,
              "1 face entities that no shape of the file refers to gave no face: #90000");
}

TEST_F(CadLosses, FacesOfAPartWithoutItsPlace) {
    std::string occurrence;
    const SurfaceModel model = assembly([&](std::string& text) {
        make_unknown(text, entity(text, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", 1));
        occurrence = entity(text, "NEXT_ASSEMBLY_USAGE_OCCURRENCE", 1);
    });
    EXPECT_EQ(model.instances.size(), 1u);
    expect(model, 6, 6, "is not placed by occurrence " + occurrence);
}

TEST_F(CadLosses, FacesOfAnOccurrenceThatIsUnknown) {
    std::string placement;
    const SurfaceModel model = assembly([&](std::string& text) {
        placement = entity(text, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", 1);
        make_unknown(text, entity(text, "NEXT_ASSEMBLY_USAGE_OCCURRENCE", 1));
    });
    expect(model, 6, 6, "has no known place by " + placement);
}

TEST_F(CadLosses, FacesOfAPartWhoseTransformationIsUnknown) {
    const SurfaceModel model = assembly([](std::string& text) {
        make_unknown(text, entity(text, "ITEM_DEFINED_TRANSFORMATION", 1));
    });
    expect(model, 6, 6, "has no known place by ");
}

TEST_F(CadLosses, AFileOfPartsThatIsNotThere) {
    opencascade::handle<TDocStd_Document> document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label whole = shapes->NewShape();
    for (const char* name : {"left", "right"}) {
        const TDF_Label part = shapes->AddShape(box(), false);
        TDataStd_Name::Set(part, name);
        shapes->AddComponent(whole, part, moved(0));
    }
    shapes->UpdateAssemblies();
    const auto path = folder.path() / "both.step";
    STEPCAFControl_Writer writer;
    ASSERT_TRUE(writer.Transfer(document, STEPControl_AsIs, "part-"));
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    expect(load_model(path), 12, 0, "");
    ASSERT_TRUE(std::filesystem::remove(folder.path() / "part-left.stp"));
    const SurfaceModel model = load_model(path);
    expect(model, 6, 1, "its file of parts cannot be read");
    EXPECT_EQ(model.lost_faces.at(0).name, "part-left.stp");
}

struct CadLostBounds : CadLosses, testing::WithParamInterface<const char*> {};

/// Both faces around the hole are lost where its circle or edge is, and one with its own loop.
TEST_P(CadLostBounds, LoseTheirFaces) {
    const SurfaceModel model = step(bored_box(), [](std::string& text) {
        const std::size_t circle = text.find("= CIRCLE(");
        ASSERT_NE(circle, std::string::npos);
        const std::string kind = std::string("= ") + GetParam() + "(";
        const std::size_t at = text.rfind(kind, circle);
        ASSERT_NE(at, std::string::npos);
        text.insert(at + 2, "UN");
    });
    EXPECT_EQ(model.faces.size() + model.lost_faces.size(), 13u);
    ASSERT_FALSE(model.lost_faces.empty());
    for (const LostFace& face : model.lost_faces) {
        EXPECT_EQ(face.reason.find("bound #"), 0u) << face.reason;
        EXPECT_NE(face.reason.find(" lacks edge "), std::string::npos) << face.reason;
    }
}

INSTANTIATE_TEST_SUITE_P(Each, CadLostBounds,
                         testing::Values("CIRCLE", "SURFACE_CURVE", "EDGE_CURVE"),
                         [](const auto& tested) { return std::string(tested.param); });

struct CadLossesOfIges : CadLosses, testing::WithParamInterface<int> {
    /// A file of a shape as trimmed surfaces (0) or as a solid (1).
    std::filesystem::path written(const TopoDS_Shape& shape) {
        const auto path = folder.path() / "shape.igs";
        IGESControl_Writer writer("MM", GetParam());
        writer.AddShape(shape);
        writer.ComputeModel();
        EXPECT_TRUE(writer.Write(path.c_str()));
        return path;
    }

    /// Places at which the parameters of each entity of a type begin.
    static std::vector<std::size_t> parameters_of(const std::string& iges,
                                                  const std::string& type) {
        std::vector<std::size_t> places;
        const std::string begin = "\n" + type + ",";
        for (std::size_t at = iges.find(begin); at != std::string::npos;
             at = iges.find(begin, at + 1))
            places.push_back(at + 1);
        return places;
    }

    /// A box whose first surface is no entity any more.
    SurfaceModel damaged_box() {
        return edited(written(box()), [](std::string& text) {
            std::size_t at = std::string::npos;
            for (const char* surface : {"\n128,", "\n108,", "\n190,"})
                at = std::min(at, text.find(surface));
            ASSERT_NE(at, std::string::npos);
            text.replace(at + 1, 2, "XX");
        });
    }
};

TEST_P(CadLossesOfIges, AnOffsetSurfaceOfAKinkThatTheReaderSmooths) {
    for (const double slope : {0.05, 0.0}) {
        TopoDS_Compound both;
        BRep_Builder builder;
        builder.MakeCompound(both);
        builder.Add(both, box());
        builder.Add(both, offset_of_kink(slope, 3));
        const std::size_t lost = slope > 0 ? 1 : 0;
        expect(load_model(written(both)), 7 - lost, lost,
               "smoothed a kink of its offset surface entity D");
    }
}

TEST_P(CadLossesOfIges, AFaceWithoutItsSurface) {
    expect(damaged_box(), 5, 1, " gave no face");
}

/// Whatever entity of curves or loops is unknown, no face has fewer trim loops in silence.
TEST_P(CadLossesOfIges, AFaceWithoutOneOfItsLoops) {
    const auto path = written(bored_box());
    const std::string text = read_file(path);
    const std::size_t loops = load_model(path).trim_loops.size();
    ASSERT_EQ(loops, 9u);
    int lost = 0;
    for (const char* type : {"100", "102", "110", "120", "126", "142", "504", "508"})
        for (const std::size_t at : parameters_of(text, type)) {
            SCOPED_TRACE(type);
            try {
                const SurfaceModel model =
                    edited(path, [at](std::string& damaged) { damaged.replace(at, 2, "XX"); });
                EXPECT_TRUE(model.trim_loops.size() == loops || !model.lost_faces.empty());
                if (!model.lost_faces.empty()) ++lost;
            } catch (const Error&) {
                ++lost; // the reader crashed on it
            }
        }
    EXPECT_GT(lost, 10);
}

INSTANTIATE_TEST_SUITE_P(Each, CadLossesOfIges, testing::Values(0, 1));

TEST(CadLostFaces, OneWithoutASurface) {
    TopoDS_Face bare;
    BRep_Builder builder;
    builder.MakeFace(bare);
    builder.Add(bare, TopExp_Explorer(box(), TopAbs_WIRE).Current());
    expect(converted(bare), 0, 1, "it has no surface");
}

TEST(CadDuplicates, AShapeThatACompoundListsTwiceIsThereTwice) {
    TopoDS_Compound twice, shared;
    BRep_Builder builder;
    builder.MakeCompound(twice);
    const TopoDS_Shape solid = box();
    builder.Add(twice, solid);
    builder.Add(twice, solid);
    EXPECT_EQ(converted(twice).faces.size(), 12u);
    builder.MakeCompound(shared);
    builder.Add(shared, solid);
    builder.Add(shared, TopExp_Explorer(solid, TopAbs_FACE).Current());
    EXPECT_EQ(converted(shared).faces.size(), 6u) << "a face of two shapes is one face";
}

} // namespace
} // namespace keiko::cad
