// Embree's two packaged versions, 3 and 4, behind one set of calls. Included by reference/*.cpp only.
#pragma once
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <glm/glm.hpp>
#include <memory>
#include <type_traits>

namespace sward {

// The first member of what a query hands to the callbacks of user geometry.
#if RTC_VERSION_MAJOR >= 4
using RayContext = RTCRayQueryContext;
#else
using RayContext = RTCIntersectContext;
#endif

// A ray that every mask lets through. `way` need not be of unit length: near and far are in its lengths.
inline RTCRay embreeRay(const glm::vec3& origin, const glm::vec3& way, float near, float far) {
    RTCRay ray{};
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = way.x, ray.dir_y = way.y, ray.dir_z = way.z;
    ray.tnear = near, ray.tfar = far;
    ray.mask = ~0u;
    return ray;
}

// The closest hit; hit.geomID is RTC_INVALID_GEOMETRY_ID where there is none. `context` need not be initialised.
inline void closestHit(RTCScene scene, RayContext& context, RTCRayHit& ray) {
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcInitRayQueryContext(&context);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    rtcIntersect1(scene, &ray, &arguments);
#else
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}
// Whether anything is hit.
inline bool anyHit(RTCScene scene, RayContext& context, RTCRay ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcInitRayQueryContext(&context);
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    rtcOccluded1(scene, &ray, &arguments);
#else
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
    return ray.tfar < 0;
}

// Gives back what Embree made, for the pointers below.
struct DropDevice {
    // Releases the device.
    void operator()(RTCDevice d) const { rtcReleaseDevice(d); }
};
struct DropScene {
    // Releases the scene.
    void operator()(RTCScene s) const { rtcReleaseScene(s); }
};
using DevicePtr = std::unique_ptr<std::remove_pointer_t<RTCDevice>, DropDevice>;
using ScenePtr = std::unique_ptr<std::remove_pointer_t<RTCScene>, DropScene>;

// A scene of so many boxes, each around something that callbacks know how to meet; any: null where nobody asks whether
// a ray meets anything. `owner`: what callbacks get as the geometry's own; it must outlive the scene.
template <void (*Bounds)(const RTCBoundsFunctionArguments*)>
ScenePtr sceneOfBoxes(RTCDevice device, size_t boxes, void* owner, RTCIntersectFunctionN closest,
                      RTCOccludedFunctionN any) {
    ScenePtr scene(rtcNewScene(device));
    RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(boxes));
    rtcSetGeometryUserData(g, owner);
    rtcSetGeometryBoundsFunction(
        g, [](const RTCBoundsFunctionArguments* a) { Bounds(a); }, nullptr);
    rtcSetGeometryIntersectFunction(g, closest);
    if (any) rtcSetGeometryOccludedFunction(g, any);
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene.get(), g);
    rtcReleaseGeometry(g);
    rtcCommitScene(scene.get());
    return scene;
}

}  // namespace sward
