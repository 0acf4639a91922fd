#include "reference/ray_scene.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace sward {

struct RayScene::Device {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = device ? rtcNewScene(device) : nullptr;
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
    // False without memory.
    bool add(const Triangles& t) {
        RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), t.positions.size());
        void* indices = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), t.indices.size() / 3);
        const bool done = vertices && indices;
        if (done) {
            std::memcpy(vertices, t.positions.data(), t.positions.size() * sizeof(glm::vec3));
            std::memcpy(indices, t.indices.data(), t.indices.size() * sizeof(uint32_t));
            rtcCommitGeometry(g);
            rtcAttachGeometry(scene, g);
        }
        rtcReleaseGeometry(g);
        return done;
    }
};

Result<RayScene> RayScene::make(const std::vector<Triangles>& meshes) {
    const Error failed{ExitCode::Failed, "rays cannot be prepared: Embree has no memory, or does not know this processor", "", 0, 0, "close other programs, or make the objects simpler"};
    auto device = std::make_shared<Device>();
    if (!device->scene) return failed;
    rtcSetSceneFlags(device->scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between neighbours
    for (const Triangles& t : meshes)
        if (!t.indices.empty() && !device->add(t)) return failed;
    rtcCommitScene(device->scene);
    if (rtcGetDeviceError(device->device) != RTC_ERROR_NONE) return failed;
    return RayScene(std::move(device));
}

bool RayScene::hits(const glm::vec3& origin, const glm::vec3& way, float far) const {
    RTCRay ray{};
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = way.x, ray.dir_y = way.y, ray.dir_z = way.z;
    ray.tfar = far;
    ray.mask = ~0u;
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(device_->scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(device_->scene, &context, &ray);
#endif
    return ray.tfar < 0;
}

}  // namespace sward
