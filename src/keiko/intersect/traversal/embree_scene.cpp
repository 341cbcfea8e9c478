#include "keiko/intersect/traversal/embree_scene.h"

#include "keiko/base/error.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <limits>
#include <string>
#include <vector>

namespace keiko {
namespace {

/// Padding of boxes against single precision. In units of 2^-24 R, with R the scene's radius, that
/// costs 1 for the start and 2 for the way of up to 2 R along the rounded direction. The slab test
/// b * r - o * r costs 6, and 2 more for its own roundings. There r = 1 / d is good to some 1.5
/// units in its last place and b - o is up to 2 R. (That is Embree's test for user geometry, even
/// in a robust scene.) The next power of two leaves 5 for the error of a start that comes from
/// afar: enter() takes rays up to 4.
constexpr double pad_in_radii = 16.0 / (1 << 24);

/// Found by the callbacks through the context, and in it by ray.id: Embree may shuffle lanes.
struct Search : RTCIntersectContext {
    const RayPacket* rays = nullptr;
    EmbreeScene::Visitor* visitor = nullptr;
    std::exception_ptr failure;
};

/// Far end of a ray that has ended.
constexpr float ended = -std::numeric_limits<float>::infinity();

/// The nearest single numbers that leave no distance out. Ends of 0 and below are kept at 0,
/// where Embree wants them; a lane that has ended stays so.
float near_end(double low) {
    return low > 0 ? static_cast<float>(low) * (1 - 0x1p-23F) : 0.0F;
}
float far_end(double high) {
    if (high > 0) return static_cast<float>(high) * (1 + 0x1p-23F);
    return high == -std::numeric_limits<double>::infinity() ? ended : 0.0F;
}

/// mm along a ray to where Embree's own begins: it knows no distances below 0, and a ray may be
/// met behind its start.
double begin_of(const RayPacket& rays, std::size_t lane) {
    return rays.low[lane] < 0 ? rays.low[lane] : 0;
}

LaneMask visit(Search& search, unsigned box, LaneMask lanes) {
    try {
        return search.visitor->visit(box, lanes);
    } catch (...) {
        search.failure = std::current_exception();
        return 0;
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
    const unsigned count = arguments->N;
    RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, count);
    LaneMask lanes = 0;
    for (unsigned i = 0; i < count; ++i)
        if (arguments->valid[i] != 0) lanes |= LaneMask{1} << RTCRayN_id(rays, count, i);
    const LaneMask lowered = search.failure ? 0 : visit(search, arguments->primID, lanes);
    const LaneMask changed = search.failure ? lanes : lowered;
    if (changed == 0) return;
    for (unsigned i = 0; i < count; ++i) {
        const std::size_t lane = RTCRayN_id(rays, count, i);
        if (arguments->valid[i] == 0 || (changed >> lane & 1) == 0) continue;
        RTCRayN_tfar(rays, count, i) =
            search.failure ? ended
                           : far_end(search.rays->high[lane] - begin_of(*search.rays, lane));
    }
}

} // namespace

struct EmbreeScene::Handles {
    RTCDevice device;
    RTCScene scene;

    explicit Handles(const char* settings)
        : device(rtcNewDevice(settings)), scene(rtcNewScene(device)) {}
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
    /// Embree reads the boxes while it builds, not later.
    void build(std::vector<Box3> boxes) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
        rtcSetGeometryUserData(geometry, boxes.data());
        rtcSetGeometryBoundsFunction(
            geometry, [](const RTCBoundsFunctionArguments* a) { on_bounds(a); }, nullptr);
        rtcSetGeometryIntersectFunction(geometry, on_intersect);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }
    void check() const {
        if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
            throw Error("", "box hierarchy", "Embree error " + std::to_string(error));
    }
};

EmbreeScene::EmbreeScene(std::span<const Box3> boxes, int threads) {
    for (const Box3& box : boxes) bounds_.extend(box);
    center_ = bounds_.empty() ? Vec3(0) : bounds_.center();
    radius_ = bounds_.size() / 2;
    // Embree drops larger boxes without a word.
    constexpr double largest = 1e18;
    if (!(radius_ < largest)) throw Error("", "model", "it is larger than 1e18 mm");
    const std::string settings = threads > 0 ? "threads=" + std::to_string(threads) : "";
    handles_ = std::make_unique<Handles>(settings.c_str());
    handles_->check();
    handles_->build(padded(boxes));
    handles_->check();
}

std::vector<Box3> EmbreeScene::padded(std::span<const Box3> boxes) const {
    // Rounding of the boxes as they came; and a single point still has a box with an inside.
    const double came = 8 * std::numeric_limits<double>::epsilon() * (center_.length() + radius_);
    const double padding = std::max(radius_ * pad_in_radii + came, 1e-30);
    std::vector<Box3> result;
    for (const Box3& box : boxes)
        result.push_back(Box3{box.lower - center_, box.upper - center_}.padded(padding));
    return result;
}

EmbreeScene::~EmbreeScene() = default;

namespace {

void trace_single(RTCScene scene, Search& search, const Vec3& center, std::size_t lane) {
    const RayPacket& rays = *search.rays;
    RTCRayHit query;
    const double begin = begin_of(rays, lane);
    const auto origin = [&](std::size_t k, double middle) {
        return static_cast<float>(rays.start[k][lane] + rays.direction[k][lane] * begin - middle);
    };
    query.ray.org_x = origin(0, center.x);
    query.ray.org_y = origin(1, center.y);
    query.ray.org_z = origin(2, center.z);
    query.ray.dir_x = static_cast<float>(rays.direction[0][lane]);
    query.ray.dir_y = static_cast<float>(rays.direction[1][lane]);
    query.ray.dir_z = static_cast<float>(rays.direction[2][lane]);
    query.ray.tnear = near_end(rays.low[lane] - begin);
    query.ray.tfar = far_end(rays.high[lane] - begin);
    query.ray.time = 0;
    query.ray.mask = 0xffffffff;
    query.ray.id = static_cast<unsigned>(lane);
    query.ray.flags = 0;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &search, &query);
}

/// Traces the active rays. Processors without vectors of 16 lanes read the others as well, and take
/// those that have not ended for active.
void trace_packet(RTCScene scene, Search& search, const Vec3& center) {
    const RayPacket& rays = *search.rays;
    RTCRayHit16 query;
    alignas(64) int valid[RayPacket::capacity];
    const auto is_active = [&](std::size_t i) { return (rays.active >> i & 1) != 0; };
    RayPacket::Lanes<double> begin;
    for (std::size_t i = 0; i < RayPacket::capacity; ++i) begin[i] = begin_of(rays, i);
    const auto set = [&](std::size_t k, double middle, float* origin, float* direction) {
        for (std::size_t i = 0; i < RayPacket::capacity; ++i) {
            const double start = rays.start[k][i] + rays.direction[k][i] * begin[i] - middle;
            origin[i] = is_active(i) ? static_cast<float>(start) : 0.0F;
            direction[i] = is_active(i) ? static_cast<float>(rays.direction[k][i]) : 0.0F;
        }
    };
    set(0, center.x, query.ray.org_x, query.ray.dir_x);
    set(1, center.y, query.ray.org_y, query.ray.dir_y);
    set(2, center.z, query.ray.org_z, query.ray.dir_z);
    for (unsigned i = 0; i < RayPacket::capacity; ++i) {
        valid[i] = is_active(i) ? -1 : 0;
        query.ray.tnear[i] = is_active(i) ? near_end(rays.low[i] - begin[i]) : 0.0F;
        query.ray.tfar[i] = is_active(i) ? far_end(rays.high[i] - begin[i]) : ended;
        query.ray.time[i] = 0;
        query.ray.mask[i] = 0xffffffff;
        query.ray.id[i] = i;
        query.ray.flags[i] = 0;
        query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    search.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, scene, &search, &query);
}

} // namespace

void EmbreeScene::trace(const RayPacket& rays, Visitor& visitor) const {
    Search search;
    rtcInitIntersectContext(&search);
    search.rays = &rays;
    search.visitor = &visitor;
    constexpr int fewest_for_packet = 3;
    if (rays.coherent && std::popcount(rays.active) >= fewest_for_packet) {
        trace_packet(handles_->scene, search, center_);
    } else {
        for (LaneMask left = rays.active; left != 0; left &= left - 1)
            trace_single(handles_->scene, search, center_,
                         static_cast<std::size_t>(std::countr_zero(left)));
    }
    if (search.failure) std::rethrow_exception(search.failure);
}

std::string embree_version() {
    RTCDevice device = rtcNewDevice(nullptr);
    if (!device) throw Error("", "Embree", "it cannot be started");
    const auto number = [device](RTCDeviceProperty property) {
        return std::to_string(rtcGetDeviceProperty(device, property));
    };
    const std::string version = number(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." +
                                number(RTC_DEVICE_PROPERTY_VERSION_MINOR) + "." +
                                number(RTC_DEVICE_PROPERTY_VERSION_PATCH);
    rtcReleaseDevice(device);
    return version;
}

} // namespace keiko
