#include "keiko/import/subdivision/limit_table.h"

#include "keiko/base/error.h"

#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>

namespace keiko::subdivision {

namespace {

using Far = osd::Far::PatchTableFactory;

Far::Options table_options(const Cage& cage, int level) {
    Far::Options options(static_cast<unsigned>(level));
    options.useInfSharpPatch = true;
    // Chaikin's rule blends sharpness along an edge: what looks uniform on one level is not so on
    // the next.
    options.useSingleCreasePatch = cage.crease_method == CreaseMethod::uniform;
    options.generateLegacySharpCornerPatches = false;
    options.SetEndCapType(Far::Options::ENDCAP_GREGORY_BASIS);
    options.SetPatchPrecision<double>();
    options.generateVaryingTables = false;
    options.generateVaryingLocalPoints = false;
    return options;
}

} // namespace

std::vector<int> LimitTable::points_by_level(const Cage& cage, int level) {
    const auto refiner = make_refiner(cage);
    refiner->RefineAdaptive(table_options(cage, level).GetRefineAdaptiveOptions());
    std::vector<int> counts(static_cast<std::size_t>(level) + 1, 0);
    for (int l = 0; l < refiner->GetNumLevels(); ++l)
        counts[static_cast<std::size_t>(l)] = refiner->GetLevel(l).GetNumVertices();
    return counts;
}

LimitTable::LimitTable(const Cage& cage, int level) : triangular_(cage.scheme == Scheme::loop) {
    // The refined mesh is most of the memory, and not needed once its points are known.
    const std::unique_ptr<osd::Far::TopologyRefiner> refiner = make_refiner(cage);
    const Far::Options options = table_options(cage, level);
    has_creases_ = options.useSingleCreasePatch;
    refiner->RefineAdaptive(options.GetRefineAdaptiveOptions());
    table_.reset(Far::Create(*refiner, options));
    if (!table_) throw Error("", "", "OpenSubdiv gives no patches for the cage");
    map_ = std::make_unique<osd::Far::PatchMap>(*table_);

    center_ = cage.box().center();
    const auto total = static_cast<std::size_t>(refiner->GetNumVerticesTotal());
    points_.resize(total + static_cast<std::size_t>(table_->GetNumLocalPoints()));
    for (std::size_t i = 0; i < cage.vertices.size(); ++i)
        points_[i].v = cage.vertices[i] - center_;
    const osd::Far::PrimvarRefinerReal<double> values(*refiner);
    Value* from = points_.data();
    for (int l = 1; l < refiner->GetNumLevels(); ++l) {
        Value* to = from + refiner->GetLevel(l - 1).GetNumVertices();
        values.Interpolate(l, from, to);
        from = to;
    }
    add_local_points(total);
    tilt_caps(*refiner, from);
}

/// The control points of caps. OpenSubdiv's weights for them carry single precision here and there:
/// applied to points relative to one of them they do no harm, applied to coordinates they turn
/// the normals of small caps by 1e-4.
void LimitTable::add_local_points(std::size_t first) {
    const auto* stencils = table_->GetLocalPointStencilTable<double>();
    for (int i = 0; i < table_->GetNumLocalPoints(); ++i) {
        const auto stencil = stencils->GetStencil(i);
        const auto point = [&](int k) {
            return points_[static_cast<std::size_t>(stencil.GetVertexIndices()[k])].v;
        };
        const Vec3 origin = point(0);
        Vec3 sum(0);
        for (int k = 0; k < stencil.GetSize(); ++k)
            sum += (point(k) - origin) * stencil.GetWeights()[k];
        points_[first + static_cast<std::size_t>(i)].v = origin + sum;
    }
}

/// The limit masks hold at the irregular vertices of the last level: all their faces are there.
void LimitTable::tilt_caps(const osd::Far::TopologyRefiner& refiner, const Value* last_level) {
    std::size_t count = 0;
    for (int array = 0; array < table_->GetNumPatchArrays(); ++array) {
        first_in_array_.push_back(count);
        count += static_cast<std::size_t>(table_->GetNumPatches(array));
    }
    const std::vector<Index> irregular = caps();
    if (irregular.empty()) return;

    const osd::Far::TopologyLevel& last = refiner.GetLevel(refiner.GetMaxLevel());
    const auto size = static_cast<std::size_t>(last.GetNumVertices());
    std::vector<Value> position(size), du(size), dv(size);
    osd::Far::PrimvarRefinerReal<double>(refiner).Limit(last_level, position, du, dv);
    std::vector<IrregularPoint> points;
    for (std::size_t i = 0; i < size; ++i) {
        const auto vertex = static_cast<int>(i);
        const Vec3 normal = du[i].v.cross(dv[i].v);
        if (last.GetVertexRule(vertex) != osd::Sdc::Crease::RULE_SMOOTH ||
            last.IsVertexValenceRegular(vertex) || !(normal.length() > 0))
            continue;
        points.push_back({position[i].v, normal.normalized()});
    }
    const IrregularPoints search(points);
    first_tilt_ = position_of(irregular.front());
    for (const Index index : irregular) tilts_.push_back(tilt_of(index, search));
}

CapTilt LimitTable::tilt_of(Index index, const IrregularPoints& points) const {
    constexpr std::array<std::array<double, 2>, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    constexpr std::array<std::array<double, 2>, 3> triangle{{{0, 0}, {1, 0}, {0, 1}}};
    const std::size_t corners = triangular_ ? 3 : 4;
    std::array<LimitPoint, 4> at;
    for (std::size_t k = 0; k < corners; ++k) {
        const auto& uv = triangular_ ? triangle[k] : square[k];
        at[k] = evaluate_table(index, uv[0], uv[1]);
    }
    for (std::size_t k = 0; k < corners; ++k) {
        const LimitPoint &here = at[k], &next = at[(k + 1) % corners];
        constexpr double near = 1e-3;
        const double reach = near * (next.position - here.position).length();
        const IrregularPoint* found = points.find(here.position, here.normal(), reach);
        if (!found) continue;
        const Vec3 &n = found->normal, &u = here.du, &v = here.dv;
        const std::array<Vec3, 4> along = triangular_ ? std::array<Vec3, 4>{u, v - u, -v, Vec3(0)}
                                                      : std::array<Vec3, 4>{u, v, -u, -v};
        // Along the border that begins in this corner, and back along the one that ends in it.
        const Vec3 &out = along[k], back = -along[(k + corners - 1) % corners];
        return {static_cast<int>(k), n, out.dot(n), back.dot(n)};
    }
    return {};
}

std::size_t LimitTable::position_of(Index index) const {
    return first_in_array_[static_cast<std::size_t>(index.array)] +
           static_cast<std::size_t>(index.patch);
}

std::vector<LimitTable::Index> LimitTable::patches() const {
    std::vector<Index> all;
    for (int array = 0; array < table_->GetNumPatchArrays(); ++array)
        for (int patch = 0; patch < table_->GetNumPatches(array); ++patch)
            all.push_back({array, patch});
    return all;
}

std::vector<LimitTable::Index> LimitTable::caps() const {
    std::vector<Index> all;
    for (int array = 0; array < table_->GetNumPatchArrays(); ++array)
        for (int patch = 0; patch < table_->GetNumPatches(array) && !exact({array, 0}); ++patch)
            all.push_back({array, patch});
    return all;
}

PatchPlace LimitTable::place(Index index) const {
    const osd::Far::PatchParam param = table_->GetPatchParam(index.array, index.patch);
    PatchPlace place;
    place.face = static_cast<std::uint32_t>(param.GetFaceId());
    place.level = param.GetDepth();
    place.turned = triangular_ && param.IsTriangleRotated();
    const double size = double(param.GetParamFraction());
    // Turned triangles count from the far corner of the face, to their own far corner.
    const Vec2 corner = Vec2(param.GetU(), param.GetV()) * size;
    if (place.turned)
        place.box = {Vec2(1 - size) - corner, Vec2(1) - corner};
    else
        place.box = {corner, corner + Vec2(size)};
    return place;
}

bool LimitTable::exact(Index index) const {
    using Type = osd::Far::PatchDescriptor;
    const auto type = table_->GetPatchArrayDescriptor(index.array).GetType();
    return type == Type::REGULAR || type == Type::LOOP;
}

double LimitTable::crease_sharpness(Index index) const {
    const auto type = table_->GetPatchArrayDescriptor(index.array).GetType();
    if (!has_creases_ || type != osd::Far::PatchDescriptor::REGULAR) return 0;
    return double(table_->GetSingleCreasePatchSharpnessValue(index.array, index.patch));
}

unsigned LimitTable::border_mask(Index index) const {
    return table_->GetPatchParam(index.array, index.patch).GetBoundary();
}

std::array<Vec3, 16> LimitTable::spline_net(Index index) const {
    const auto vertices = table_->GetPatchVertices(index.array, index.patch);
    std::array<Vec3, 16> net;
    for (int k = 0; k < 16; ++k)
        net[static_cast<std::size_t>(k)] = points_[static_cast<std::size_t>(vertices[k])].v;
    return net;
}

osd::Far::PatchTable::PatchHandle LimitTable::handle(Index index) const {
    osd::Far::PatchTable::PatchHandle handle;
    handle.arrayIndex = index.array;
    handle.patchIndex = static_cast<int>(position_of(index));
    handle.vertIndex =
        index.patch * table_->GetPatchArrayDescriptor(index.array).GetNumControlVertices();
    return handle;
}

LimitPoint LimitTable::evaluate_table(Index index, double u, double v) const {
    constexpr std::size_t most_points = 20;
    std::array<double, most_points> weights{}, weights_u{}, weights_v{};
    const PatchPlace where = place(index);
    const Vec2 base = where.base(u, v);
    table_->EvaluateBasis(handle(index), base.x, base.y, weights.data(), weights_u.data(),
                          weights_v.data());
    const auto vertices = table_->GetPatchVertices(index.array, index.patch);
    LimitPoint point;
    for (int k = 0; k < vertices.size(); ++k) {
        const Vec3& p = points_[static_cast<std::size_t>(vertices[k])].v;
        const auto i = static_cast<std::size_t>(k);
        point.position += p * weights[i];
        point.du += p * weights_u[i];
        point.dv += p * weights_v[i];
    }
    // OpenSubdiv derives by the parameters of the base face.
    const double size = where.box.extent().x * (where.turned ? -1 : 1);
    point.du *= size, point.dv *= size;
    return point;
}

LimitPoint LimitTable::evaluate(Index index, double u, double v) const {
    LimitPoint point = evaluate_table(index, u, v);
    if (exact(index)) return point;
    const CapTilt& tilt = tilts_[position_of(index) - first_tilt_];
    // The offset is a polynomial of low degree: differences derive it well enough.
    constexpr double step = 1e-4;
    const auto offset = [&](double x, double y) { return tilt.offset(x, y, triangular_); };
    point.position += offset(u, v);
    point.du += (offset(u + step, v) - offset(u - step, v)) / (2 * step);
    point.dv += (offset(u, v + step) - offset(u, v - step)) / (2 * step);
    return point;
}

std::optional<LimitTable::Index> LimitTable::smooth_patch_at(std::uint32_t face,
                                                             const Vec2& uv) const {
    const auto* found = map_->FindPatch(static_cast<int>(face), uv.x, uv.y);
    if (!found) return std::nullopt;
    const std::size_t before = first_in_array_[static_cast<std::size_t>(found->arrayIndex)];
    const Index index{found->arrayIndex, found->patchIndex - static_cast<int>(before)};
    if (!exact(index) || crease_sharpness(index) > 0) return std::nullopt;
    return index;
}

} // namespace keiko::subdivision
