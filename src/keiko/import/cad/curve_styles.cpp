#include "keiko/import/cad/curve_styles.h"

#include "keiko/base/text.h"

#include <IGESBasic_Name.hxx>
#include <IGESCAFControl.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESGraph_Color.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepData_StepModel.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <Transfer_TransientListBinder.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <map>
#include <tuple>
#include <vector>

namespace keiko::cad {
namespace {

Quantity_Color occt_color(const Rgb& color) {
    return {color.r, color.g, color.b, Quantity_TOC_RGB};
}

/// Colours of an IGES file that are none of the standard's own, each once.
class IgesColors {
public:
    explicit IgesColors(IGESControl_Writer& writer) : writer_(writer) {}

    void give(IGESData_IGESEntity& entity, const Rgb& color) {
        const int standard = IGESCAFControl::EncodeColor(occt_color(color));
        if (standard > 0) return entity.InitColor({}, standard);
        auto& known = colors_[{color.r, color.g, color.b}];
        if (known.IsNull()) {
            constexpr double percent = 100;
            double r = 0, g = 0, b = 0;
            occt_color(color).Values(r, g, b, Quantity_TOC_sRGB); // as readers take it
            known = new IGESGraph_Color;
            known->Init(r * percent, g * percent, b * percent, new TCollection_HAsciiString(""));
            writer_.AddEntity(known);
        }
        entity.InitColor(known);
    }

private:
    IGESControl_Writer& writer_;
    std::map<std::tuple<double, double, double>, opencascade::handle<IGESGraph_Color>> colors_;
};

opencascade::handle<IGESData_IGESEntity> iges_entity(const IGESControl_Writer& writer,
                                                     const TopoDS_Shape& shape) {
    opencascade::handle<IGESData_IGESEntity> entity;
    const auto& process = writer.TransferProcess();
    const auto mapper = TransferBRep::ShapeMapper(process, shape);
    process->FindTypedTransient(mapper, STANDARD_TYPE(IGESData_IGESEntity), entity);
    return entity;
}

/// The items that a shape has become.
std::vector<opencascade::handle<StepRepr_RepresentationItem>> step_items(
    const opencascade::handle<Transfer_FinderProcess>& process, const TopoDS_Shape& shape) {
    if (const auto item = STEPConstruct::FindEntity(process, shape); !item.IsNull()) return {item};
    std::vector<opencascade::handle<StepRepr_RepresentationItem>> items;
    const auto list = opencascade::handle<Transfer_TransientListBinder>::DownCast(
        process->Find(TransferBRep::ShapeMapper(process, shape)));
    for (int i = 1; !list.IsNull() && i <= list->NbTransients(); ++i)
        if (const auto item =
                opencascade::handle<StepRepr_RepresentationItem>::DownCast(list->Transient(i));
            !item.IsNull())
            items.push_back(item);
    return items;
}

} // namespace

void add_step_colors(STEPCAFControl_Writer& writer, const CurveSet& set,
                     const std::vector<TopoDS_Shape>& shapes) {
    const auto session = writer.ChangeWriter().WS();
    const auto process = session->TransferWriter()->FinderProcess();
    STEPConstruct_DataMapOfAsciiStringTransient fonts;
    STEPConstruct_DataMapOfPointTransient colors;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (!set.curves[i].color) continue;
        STEPConstruct_Styles styles(session);
        const auto color =
            STEPConstruct_Styles::EncodeColor(occt_color(*set.curves[i].color), fonts, colors);
        for (TopExp_Explorer edges(shapes[i], TopAbs_EDGE); edges.More(); edges.Next())
            for (const auto& item : step_items(process, edges.Current()))
                styles.AddStyle(item, styles.MakeColorPSA(item, {}, color, {}, 0), {});
        opencascade::handle<StepVisual_MechanicalDesignGeometricPresentationRepresentation> shown;
        if (styles.CreateMDGPR(styles.FindContext(shapes[i]), shown))
            writer.ChangeWriter().Model()->AddWithRefs(shown);
    }
}

void add_iges_names_and_colors(IGESControl_Writer& writer, const CurveSet& set,
                               const std::vector<TopoDS_Shape>& shapes) {
    IgesColors colors(writer);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const NamedCurve& curve = set.curves[i];
        if (const auto entity = iges_entity(writer, shapes[i]); !entity.IsNull()) {
            opencascade::handle<IGESBasic_Name> name = new IGESBasic_Name;
            name->Init(1, new TCollection_HAsciiString(one_line(curve.name).c_str()));
            entity->AddProperty(name);
            writer.AddEntity(name);
        }
        if (!curve.color) continue;
        for (TopExp_Explorer edges(shapes[i], TopAbs_EDGE); edges.More(); edges.Next())
            if (const auto entity = iges_entity(writer, edges.Current()); !entity.IsNull())
                colors.give(*entity, *curve.color);
    }
}

} // namespace keiko::cad
