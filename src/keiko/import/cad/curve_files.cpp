#include "keiko/import/cad/curve_files.h"

#include "keiko/base/error.h"
#include "keiko/import/cad/assembly.h"
#include "keiko/import/cad/curve_styles.h"
#include "keiko/import/cad/shape_attributes.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <optional>
#include <sstream>

namespace keiko::cad {
namespace {

/// Knots as OpenCASCADE has them: each once, with its multiplicity.
struct DistinctKnots {
    std::vector<double> knots;
    std::vector<int> multiplicities;

    explicit DistinctKnots(const std::vector<double>& repeated) {
        for (const double knot : repeated)
            if (!knots.empty() && knots.back() == knot)
                ++multiplicities.back();
            else
                knots.push_back(knot), multiplicities.push_back(1);
    }
};

opencascade::handle<Geom_BSplineCurve> occt_curve(const NurbsCurve<Vec4>& curve) {
    const int count = static_cast<int>(curve.points.size());
    TColgp_Array1OfPnt poles(1, count);
    TColStd_Array1OfReal weights(1, count);
    for (int i = 0; i < count; ++i) {
        const Vec4& p = curve.points[static_cast<std::size_t>(i)];
        poles(i + 1) = gp_Pnt(p.x / p.w, p.y / p.w, p.z / p.w);
        weights(i + 1) = p.w;
    }
    const DistinctKnots distinct(curve.knots);
    const int knot_count = static_cast<int>(distinct.knots.size());
    const TColStd_Array1OfReal knots(distinct.knots.front(), 1, knot_count);
    const TColStd_Array1OfInteger multiplicities(distinct.multiplicities.front(), 1, knot_count);
    return new Geom_BSplineCurve(poles, weights, knots, multiplicities, curve.degree);
}

TopoDS_Shape edge_of(const NurbsCurve<Vec4>& piece, const std::string& name) {
    try {
        BRepBuilderAPI_MakeEdge edge(occt_curve(piece));
        if (edge.IsDone()) return edge.Shape();
    } catch (const Standard_Failure& failure) {
        throw Error("", name, failure.GetMessageString());
    }
    throw Error("", name, "OpenCASCADE makes no edge of it");
}

TopoDS_Shape shape_of(const NamedCurve& curve) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const NurbsCurve<Vec4>& piece : curve.pieces) {
        const TopoDS_Shape edge = edge_of(piece, curve.name);
        if (curve.pieces.size() == 1) return edge;
        builder.Add(compound, edge);
    }
    return compound;
}

/// Curves of a set as OpenCASCADE has them, with their names.
struct CurveDocument {
    std::vector<TopoDS_Shape> shapes; ///< one a curve
    opencascade::handle<TDocStd_Document> document = new_document();

    explicit CurveDocument(const CurveSet& set) {
        const auto tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
        for (const NamedCurve& curve : set.curves) {
            shapes.push_back(shape_of(curve));
            const TDF_Label label = tool->AddShape(shapes.back(), false);
            TDataStd_Name::Set(label, TCollection_ExtendedString(curve.name.c_str(), true));
        }
    }
};

constexpr const char* all_digits = "%.16E"; // reads back as the same number but for its last bit

opencascade::handle<TCollection_HAsciiString> occt_text(const std::string& text) {
    return new TCollection_HAsciiString(text.c_str());
}

/// The body that the curves lie on, and neither time nor user: every run gives the same bytes.
void set_header(StepData_StepModel& model, const std::string& name) {
    APIHeaderSection_MakeHeader header(&model);
    header.SetName(occt_text(name));
    header.SetTimeStamp(occt_text("1970-01-01T00:00:00"));
    header.SetAuthorValue(1, occt_text(""));
    header.SetOriginatingSystem(occt_text("Keiko"));
    header.Apply(&model);
}

/// Header of an IGES file, likewise.
void set_header(IGESData_IGESModel& model, const std::string& name) {
    IGESData_GlobalSection section = model.GlobalSection();
    section.SetFileName(occt_text(name));
    section.SetSystemId(occt_text("Keiko"));
    section.SetAuthorName({});
    section.SetDate(occt_text("19700101.000000"));
    section.SetLastChangeDate(occt_text("19700101.000000"));
    model.SetGlobalSection(section);
}

std::string step_bytes(const CurveSet& set) {
    const CurveDocument curves(set);
    STEPCAFControl_Writer writer;
    writer.SetNameMode(true);
    writer.SetColorMode(false);
    if (!writer.Transfer(curves.document, STEPControl_AsIs))
        throw Error("", "", "OpenCASCADE writes no STEP file of it");
    add_step_colors(writer, set, curves.shapes);
    const auto model = writer.ChangeWriter().Model();
    set_header(*model, set.name);
    StepData_StepWriter text(model);
    text.FloatWriter().SetFormat(all_digits);
    text.FloatWriter().SetFormatForRange(all_digits, 0, 0);
    text.SendModel(opencascade::handle<StepData_Protocol>::DownCast(model->Protocol()));
    std::ostringstream bytes;
    if (!text.Print(bytes)) throw Error("", "", "OpenCASCADE writes no STEP file of it");
    return bytes.str();
}

std::string iges_bytes(const CurveSet& set) {
    const CurveDocument curves(set);
    IGESCAFControl_Writer writer;
    writer.SetNameMode(false);
    writer.SetColorMode(false);
    if (!writer.Transfer(curves.document))
        throw Error("", "", "OpenCASCADE writes no IGES file of it");
    add_iges_names_and_colors(writer, set, curves.shapes);
    writer.ComputeModel();
    set_header(*writer.Model(), set.name);
    IGESData_IGESWriter text(writer.Model());
    text.FloatWriter().SetFormat(all_digits);
    text.FloatWriter().SetFormatForRange(all_digits, 0, 0);
    text.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
    std::ostringstream bytes;
    if (!text.Print(bytes)) throw Error("", "", "OpenCASCADE writes no IGES file of it");
    return bytes.str();
}

template <class Reader>
opencascade::handle<TDocStd_Document> read_with(const std::filesystem::path& path) {
    Reader reader;
    reader.SetNameMode(true);
    reader.SetColorMode(true);
    // Of IGES: a polyline stays one curve, and is not cut at its corners.
    Interface_Static::SetIVal("read.iges.bspline.continuity", 0);
    auto document = new_document();
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || !reader.Transfer(document))
        throw Error(path.string(), "", "holds nothing that can be read");
    return document;
}

NurbsCurve<Vec4> curve_of(const TopoDS_Edge& edge) {
    double begin = 0, end = 0;
    const auto curve = BRep_Tool::Curve(edge, begin, end);
    const auto spline = GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, begin, end));
    NurbsCurve<Vec4> result;
    result.degree = spline->Degree();
    for (int i = 1; i <= spline->NbKnots(); ++i)
        result.knots.insert(result.knots.end(), static_cast<std::size_t>(spline->Multiplicity(i)),
                            spline->Knot(i));
    for (int i = 1; i <= spline->NbPoles(); ++i) {
        const gp_Pnt p = spline->Pole(i);
        const double w = spline->Weight(i);
        result.points.emplace_back(p.X() * w, p.Y() * w, p.Z() * w, w);
    }
    return result;
}

std::optional<Rgb> color_of(const TopoDS_Shape& shape, XCAFDoc_ColorTool& colors) {
    Quantity_Color color;
    if (colors.GetColor(shape, XCAFDoc_ColorCurv, color) ||
        colors.GetColor(shape, XCAFDoc_ColorGen, color))
        return Rgb(color.Red(), color.Green(), color.Blue());
    return std::nullopt;
}

NamedCurve named_curve(const TDF_Label& label, XCAFDoc_ColorTool& colors) {
    NamedCurve curve{name_of(label)};
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    curve.color = color_of(shape, colors);
    for (TopExp_Explorer edges(shape, TopAbs_EDGE, TopAbs_FACE); edges.More(); edges.Next()) {
        const auto& edge = TopoDS::Edge(edges.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        curve.pieces.push_back(curve_of(edge));
        // OpenCASCADE colours the pieces of a compound, and not the compound.
        if (!curve.color) curve.color = color_of(edges.Current(), colors);
    }
    return curve;
}

} // namespace

std::string curve_file(const CurveSet& set, ModelFormat format) {
    return format == ModelFormat::step ? step_bytes(set) : iges_bytes(set);
}

CurveSet read_curves(const std::filesystem::path& path, ModelFormat format) {
    const auto document = format == ModelFormat::step ? read_with<STEPCAFControl_Reader>(path)
                                                      : read_with<IGESCAFControl_Reader>(path);
    CurveSet set{path.stem().string()};
    TDF_LabelSequence labels;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(labels);
    const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
    for (const TDF_Label& label : labels)
        if (NamedCurve curve = named_curve(label, *colors); !curve.pieces.empty())
            set.curves.push_back(std::move(curve));
    if (set.curves.empty()) throw Error(path.string(), "", "no free curves in the file");
    return set;
}

} // namespace keiko::cad
