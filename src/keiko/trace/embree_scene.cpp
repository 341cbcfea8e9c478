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
    EmbreeScene::Visitor* const* visitors = nullptr;
    std::exception_ptr failure;
};

/// One box for one ray; what is left of the ray.
float visited(Search& search, unsigned ray, unsigned box, float tfar) {
    constexpr float stop = -std::numeric_limits<float>::infinity();
    if (search.failure) return stop;
    try {
        const double left = search.visitors[ray]->visit(box);
        return left < 0 ? stop : std::min(tfar, round_up(left));
    } catch (...) {
        search.failure = std::current_exception();
        return stop;
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
    for (unsigned lane = 0; lane < arguments->N; ++lane) {
        if (arguments->valid[lane] == 0) continue;
        float& tfar = RTCRayN_tfar(rays, arguments->N, lane);
        tfar = visited(search, RTCRayN_id(rays, arguments->N, lane), arguments->primID, tfar);
    }
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
    const double pad = std::max(radius_ * pad_in_radii, 1e-30);
    std::vector<Box3> padded;
    for (const Box3& box : boxes)
        padded.push_back(Box3{box.lower - center_, box.upper - center_}.padded(pad));

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

void EmbreeScene::trace(const Vec3& start, const Vec3& direction, double length,
                        Visitor& visitor) const {
    Search search;
    rtcInitIntersectContext(&search);
    Visitor* const visitors[] = {&visitor};
    search.visitors = visitors;
    const Vec3 local = start - center_;
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(local.x);
    query.ray.org_y = static_cast<float>(local.y);
    query.ray.org_z = static_cast<float>(local.z);
    query.ray.dir_x = static_cast<float>(direction.x);
    query.ray.dir_y = static_cast<float>(direction.y);
    query.ray.dir_z = static_cast<float>(direction.z);
    query.ray.tfar = round_up(length);
    query.ray.mask = 0xffffffff;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(handles_->scene, &search, &query);
    if (search.failure) std::rethrow_exception(search.failure);
}

} // namespace keiko
