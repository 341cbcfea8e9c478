#include "keiko/trace/embree_scene.h"

#include "keiko/base/error.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <string>
#include <vector>

namespace keiko {
namespace {

/// In units of the scene's radius R, single precision costs: half an ulp of R for the start, of
/// 2 R for the way along the rounded direction in each coordinate, and the slab test
/// (b - o) * (1 / d) some 4 roundings of values up to 2 R: 0.5 + 1 + 8 ulps of 2^-24 R. Taken
/// up to the next power of two.
constexpr double pad_in_radii = 16.0 / (1 << 24);

/// Found by the callbacks through the context, and in it by ray.id: Embree may shuffle lanes.
struct Search : RTCIntersectContext {
    const RayBlock* rays = nullptr;
    EmbreeScene::Visitor* visitor = nullptr;
    std::exception_ptr failure;
};

/// What is left of a ray for Embree.
float far_end(const RayBlock& rays, std::size_t lane) {
    // Infinity stays infinity; any other end is kept at 0 or beyond, where Embree wants it.
    const double high = rays.high[lane];
    constexpr double ended = -std::numeric_limits<double>::infinity();
    return round_up(high == ended ? high : std::max(high, 0.0));
}

void visit(Search& search, unsigned box, LaneMask lanes) {
    try {
        search.visitor->visit(box, lanes);
    } catch (...) {
        search.failure = std::current_exception();
    }
}

void on_bounds(const RTCBoundsFunctionArguments* arguments) {
    const Box3& box = static_cast<const Box3*>(arguments->geometryUserPtr)[arguments->primID];
    RTCBounds& out = *arguments->bounds_o;
    out.lower_x = round_down(box.lower.x);
    out.lower_y = round_down(box.lower.y);
    out.lower_z = round_down(box.lower.z);
    out.upper_x = round_up(box.upper.x);
    out.upper_y = round_up(box.upper.y);
    out.upper_z = round_up(box.upper.z);
}

void on_intersect(const RTCIntersectFunctionNArguments* arguments) {
    Search& search = *static_cast<Search*>(arguments->context);
    RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
    LaneMask lanes = 0;
    for (unsigned i = 0; i < arguments->N; ++i)
        if (arguments->valid[i] != 0) lanes |= LaneMask{1} << RTCRayN_id(rays, arguments->N, i);
    if (!search.failure) visit(search, arguments->primID, lanes);
    for (unsigned i = 0; i < arguments->N; ++i)
        if (arguments->valid[i] != 0)
            RTCRayN_tfar(rays, arguments->N, i) =
                search.failure ? -std::numeric_limits<float>::infinity()
                               : far_end(*search.rays, RTCRayN_id(rays, arguments->N, i));
}

} // namespace

struct EmbreeScene::Handles {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
    void check() const {
        if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
            throw Error("", "box hierarchy", "Embree error " + std::to_string(error));
    }
};

EmbreeScene::EmbreeScene(std::span<const Box3> boxes, int threads)
    : handles_(std::make_unique<Handles>()) {
    for (const Box3& box : boxes) bounds_.extend(box);
    center_ = bounds_.empty() ? Vec3(0) : bounds_.center();
    radius_ = bounds_.size() / 2;
    // A single point of a scene still has a box with an inside.
    padding_ = std::max(radius_ * pad_in_radii, 1e-30);
    std::vector<Box3> padded;
    for (const Box3& box : boxes)
        padded.push_back(Box3{box.lower - center_, box.upper - center_}.padded(padding_));

    handles_->device =
        rtcNewDevice(threads > 0 ? ("threads=" + std::to_string(threads)).c_str() : nullptr);
    handles_->check();
    handles_->scene = rtcNewScene(handles_->device);
    rtcSetSceneFlags(handles_->scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(padded.size()));
    rtcSetGeometryUserData(geometry, padded.data());
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* a) { on_bounds(a); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, on_intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handles_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(handles_->scene);
    handles_->check();
}

EmbreeScene::~EmbreeScene() = default;

namespace {

/// Lane `lane` of a block as lane `at` of an Embree query of `count` rays.
void fill(RTCRayN* query, unsigned count, unsigned at, const RayBlock& rays, std::size_t lane,
          const Vec3& center) {
    RTCRayN_org_x(query, count, at) = static_cast<float>(rays.start[0][lane] - center.x);
    RTCRayN_org_y(query, count, at) = static_cast<float>(rays.start[1][lane] - center.y);
    RTCRayN_org_z(query, count, at) = static_cast<float>(rays.start[2][lane] - center.z);
    RTCRayN_dir_x(query, count, at) = static_cast<float>(rays.direction[0][lane]);
    RTCRayN_dir_y(query, count, at) = static_cast<float>(rays.direction[1][lane]);
    RTCRayN_dir_z(query, count, at) = static_cast<float>(rays.direction[2][lane]);
    RTCRayN_tnear(query, count, at) = round_down(std::max(rays.low[lane], 0.0));
    RTCRayN_tfar(query, count, at) = far_end(rays, lane);
    RTCRayN_time(query, count, at) = 0;
    RTCRayN_mask(query, count, at) = 0xffffffff;
    RTCRayN_id(query, count, at) = static_cast<unsigned>(lane);
    RTCRayN_flags(query, count, at) = 0;
}

void trace_single(RTCScene scene, Search& search, const Vec3& center) {
    RTCRayHit query;
    fill(reinterpret_cast<RTCRayN*>(&query.ray), 1, 0, *search.rays, 0, center);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &search, &query);
}

void trace_packet(RTCScene scene, Search& search, const Vec3& center) {
    RTCRayHit16 query;
    alignas(64) int valid[RayBlock::capacity];
    for (unsigned lane = 0; lane < RayBlock::capacity; ++lane) {
        valid[lane] = lane < search.rays->count ? -1 : 0;
        const unsigned from = valid[lane] != 0 ? lane : 0;
        fill(reinterpret_cast<RTCRayN*>(&query.ray), RayBlock::capacity, lane, *search.rays, from,
             center);
        query.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    search.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, scene, &search, &query);
}

} // namespace

void EmbreeScene::trace(const RayBlock& rays, Visitor& visitor) const {
    Search search;
    rtcInitIntersectContext(&search);
    search.rays = &rays;
    search.visitor = &visitor;
    if (rays.count == 1)
        trace_single(handles_->scene, search, center_);
    else
        trace_packet(handles_->scene, search, center_);
    if (search.failure) std::rethrow_exception(search.failure);
}

} // namespace keiko
