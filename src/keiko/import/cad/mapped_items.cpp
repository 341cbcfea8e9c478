#include "keiko/import/cad/assembly.h"
#include "keiko/import/cad/shape_places.h"

#include <Interface_InterfaceModel.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_ProductDefinitionShape.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>

#include <algorithm>
#include <map>
#include <set>

namespace keiko::cad {

namespace {

using Operator = StepGeom_CartesianTransformationOperator3d;

gp_XYZ direction(const opencascade::handle<StepGeom_Direction>& entity, const gp_XYZ& otherwise) {
    if (entity.IsNull() || entity->NbDirectionRatios() != 3) return otherwise;
    const gp_XYZ d(entity->DirectionRatiosValue(1), entity->DirectionRatiosValue(2),
                   entity->DirectionRatiosValue(3));
    return d.Modulus() > 0 ? d.Normalized() : otherwise;
}

/// `d` made perpendicular to a unit vector.
gp_XYZ across(const gp_XYZ& d, const gp_XYZ& axis) {
    return d - axis * d.Dot(axis);
}

/// The operator that an item is mapped by; null where the item goes from axes to axes.
opencascade::handle<Operator> mapping_operator(
    const opencascade::handle<StepRepr_MappedItem>& item) {
    return opencascade::handle<Operator>::DownCast(item->MappingTarget());
}

/// The operator as [ISO10303-42] defines it (base_axis, cartesian_transformation_operator_3d): it
/// moves, turns, mirrors and scales. `rigid`, which holds its origin in mm, where its axes or its
/// scale make no map.
gp_Trsf whole(const opencascade::handle<Operator>& mapping, const gp_Trsf& rigid) {
    gp_XYZ w = direction(mapping->Axis3(), {0, 0, 1});
    gp_XYZ u = across(direction(mapping->Axis1(), {1, 0, 0}), w);
    const double scale = mapping->HasScale() ? mapping->Scale() : 1;
    constexpr double least = 1e-6;
    if (u.Modulus() < least || !(scale > least && scale < 1 / least)) return rigid;
    u.Normalize();
    gp_XYZ v = across(across(direction(mapping->Axis2(), {0, 1, 0}), w), u);
    if (v.Modulus() < least) return rigid;
    v.Normalize();
    u *= scale, v *= scale, w *= scale;
    const gp_XYZ& t = rigid.TranslationPart();
    gp_Trsf result;
    result.SetValues(u.X(), v.X(), w.X(), t.X(), u.Y(), v.Y(), w.Y(), t.Y(), u.Z(), v.Z(), w.Z(),
                     t.Z());
    return result;
}

} // namespace

/// Follows the entities of a file: products hold representations, those hold mapped items, which
/// map representations.
class MappedItemReader {
    using Entity = opencascade::handle<Standard_Transient>;
    using Representation = opencascade::handle<StepRepr_Representation>;
    using Item = opencascade::handle<StepRepr_MappedItem>;
    using Product = opencascade::handle<StepBasic_ProductDefinition>;
    using Usage = opencascade::handle<StepRepr_NextAssemblyUsageOccurrence>;
    using Definition = opencascade::handle<StepShape_ShapeDefinitionRepresentation>;

public:
    explicit MappedItemReader(const opencascade::handle<XSControl_WorkSession>& session)
        : process_(session->TransferReader()->TransientProcess()), model_(session->Model()) {
        for (int i = 1; i <= model_->NbEntities(); ++i) sort_in(model_->Value(i));
    }

    /// Shapes of the products that are in no other.
    std::vector<TopoDS_Shape> roots() const {
        std::vector<TopoDS_Shape> shapes;
        for (const Product& product : products_)
            if (used_.count(product) == 0) shapes.push_back(shape_of(product));
        return shapes;
    }

    std::vector<MappedItems::Assembly> assemblies() {
        if (!any_operator_) return {};
        for (const Representation& representation : representations_)
            if (lone_item(representation).IsNull()) take_items(representation);
        for (const Usage& usage : usages_) take_usage(usage);
        for (const Product& product : products_)
            if (used_.count(product) == 0) take_root(product, shown_.at(product));
        return std::move(assemblies_);
    }

private:
    void sort_in(const Entity& entity) {
        if (const auto item = Item::DownCast(entity); !item.IsNull())
            any_operator_ = any_operator_ || !mapping_operator(item).IsNull();
        if (const auto held = Representation::DownCast(entity); !held.IsNull())
            representations_.push_back(held);
        if (const auto usage = Usage::DownCast(entity); !usage.IsNull()) {
            usages_.push_back(usage);
            used_.insert(usage->RelatedProductDefinition());
        }
        if (const auto definition = Definition::DownCast(entity); !definition.IsNull())
            sort_in(definition);
    }

    void sort_in(const Definition& definition) {
        const auto shape = opencascade::handle<StepRepr_ProductDefinitionShape>::DownCast(
            definition->Definition().PropertyDefinition());
        if (shape.IsNull()) return;
        const Product product = shape->Definition().ProductDefinition();
        if (!product.IsNull() && shown_.emplace(product, definition->UsedRepresentation()).second)
            products_.push_back(product);
    }

    /// Shape that an entity gave; null where it gave none.
    TopoDS_Shape shape_of(const Entity& entity) const {
        return entity.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(process_, entity);
    }

    /// The item of a representation that has no other with a shape: OpenCASCADE makes no compound
    /// of it.
    Item lone_item(const Representation& representation) const {
        Item only;
        int shapes = 0;
        for (int i = 1; i <= representation->NbItems(); ++i) {
            const auto item = representation->ItemsValue(i);
            if (shape_of(item).IsNull()) continue;
            ++shapes;
            only = Item::DownCast(item);
        }
        return shapes == 1 ? only : Item();
    }

    /// Place of the shape of a representation in it. A representation that maps itself cannot be
    /// transferred, so it has no shape and this ends.
    gp_Trsf wanted(const Representation& representation) const {
        const Item item = lone_item(representation);
        return item.IsNull() ? place_of(shape_of(representation)) : wanted(item);
    }

    gp_Trsf wanted(const Item& item) const {
        const Representation mapped = item->MappingSource()->MappedRepresentation();
        const gp_Trsf own = place_of(shape_of(item)) * place_of(shape_of(mapped)).Inverted();
        const auto mapping = mapping_operator(item);
        return (mapping.IsNull() ? own : whole(mapping, own)) * wanted(mapped);
    }

    void take_items(const Representation& representation) {
        TopoDS_Shape compound = shape_of(representation);
        for (const Product& product : products_)
            if (compound.IsNull() && shown_.at(product) == representation)
                compound = shape_of(product);
        for (int i = 1; i <= representation->NbItems(); ++i)
            if (const auto item = Item::DownCast(representation->ItemsValue(i)); !item.IsNull())
                if (const TopoDS_Shape shape = shape_of(item); !shape.IsNull())
                    correct(compound, shape, wanted(item), item);
    }

    void take_usage(const Usage& usage) {
        const auto shown = shown_.find(usage->RelatedProductDefinition());
        const TopoDS_Shape shape = shape_of(usage);
        if (shown == shown_.end() || shape.IsNull()) return;
        if (lone_item(shown->second).IsNull()) return;
        const gp_Trsf own = place_of(shape) * place_of(shape_of(shown->first)).Inverted();
        correct(shape_of(usage->RelatingProductDefinition()), shape, own * wanted(shown->second),
                usage);
    }

    void take_root(const Product& product, const Representation& representation) {
        const TopoDS_Shape shape = shape_of(product);
        if (shape.IsNull() || lone_item(representation).IsNull()) return;
        if (alike(place_of(shape), wanted(representation))) return;
        assemblies_.push_back({{{shape}}, label(representation)});
        assemblies_.back().components.front().correction =
            affine(place_of(shape).Inverted() * wanted(representation));
    }

    /// Notes where a shape within a compound belongs.
    void correct(const TopoDS_Shape& compound, const TopoDS_Shape& shape, const gp_Trsf& place,
                 const Entity& entity) {
        if (alike(place_of(shape), place)) return;
        MappedItems::Assembly& assembly = assembly_of(compound, entity);
        for (MappedItems::Component& component : assembly.components)
            if (!component.correction && alike(component.shape, shape)) {
                component.correction = affine(place_of(shape).Inverted() * place);
                return;
            }
        assemblies_.push_back({{}, label(entity)});
    }

    MappedItems::Assembly& assembly_of(const TopoDS_Shape& compound, const Entity& entity) {
        const auto [known, is_new] = numbers_.try_emplace(
            compound.IsNull() ? nullptr : compound.TShape().get(), assemblies_.size());
        if (is_new) {
            assemblies_.push_back({{}, label(entity)});
            if (!compound.IsNull())
                for (TopoDS_Iterator child(compound, false, false); child.More(); child.Next())
                    assemblies_.back().components.push_back({child.Value()});
        }
        return assemblies_[known->second];
    }

    std::string label(const Entity& entity) const {
        return model_->StringLabel(entity)->ToCString();
    }

    opencascade::handle<Transfer_TransientProcess> process_;
    opencascade::handle<Interface_InterfaceModel> model_;
    bool any_operator_ = false;
    std::vector<Representation> representations_;
    std::vector<Usage> usages_;
    std::map<Product, Representation> shown_;
    std::vector<Product> products_; ///< of shown_, in the order of the file
    std::set<Product> used_;        ///< in assemblies
    std::vector<MappedItems::Assembly> assemblies_;
    std::map<const TopoDS_TShape*, std::size_t> numbers_; ///< of assemblies, by their compounds
};

std::optional<std::vector<Affine>> MappedItems::Assembly::match(
    const std::vector<TopoDS_Shape>& shapes) const {
    if (shapes.size() != components.size()) return std::nullopt;
    std::vector<Affine> result(shapes.size());
    std::vector<bool> taken(shapes.size(), false);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        std::size_t k = 0;
        while (k < shapes.size() && (taken[k] || !alike(components[k].shape, shapes[i]))) ++k;
        if (k == shapes.size()) return std::nullopt;
        taken[k] = true;
        if (components[k].correction) result[i] = *components[k].correction;
    }
    return result;
}

MappedItems::MappedItems(const opencascade::handle<XSControl_WorkSession>& session) {
    MappedItemReader reader(session);
    assemblies_ = reader.assemblies();
    products_ = reader.roots();
}

std::vector<Affine> MappedItems::corrections(const std::vector<TopoDS_Shape>& components) {
    if (components.empty()) return {};
    for (Assembly& assembly : assemblies_)
        if (auto found = assembly.match(components)) {
            assembly.met = true;
            return std::move(*found);
        }
    return std::vector<Affine>(components.size());
}

bool MappedItems::is_product(const TopoDS_Shape& shape) const {
    return std::any_of(products_.begin(), products_.end(),
                       [&](const TopoDS_Shape& product) { return alike(product, shape); });
}

void MappedItems::remark_unmet(Diagnostics& diagnostics) const {
    for (const Assembly& assembly : assemblies_)
        if (!assembly.met)
            diagnostics.push_back({Severity::warning, "entity " + assembly.label,
                                   "mirrors or scales what it places; it is neither mirrored nor "
                                   "scaled here"});
}

} // namespace keiko::cad
