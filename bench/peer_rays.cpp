#include "bench/peer_rays.h"

#include <limits>

#ifdef GABARIT_HAS_EMBREE
#include <embree3/rtcore.h>
#endif

namespace gabarit {

#ifdef GABARIT_HAS_EMBREE
const bool PeerRays::here = true;

PeerRays::PeerRays(const TriangleMesh& mesh) {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  scene_ = std::shared_ptr<void>(scene, [device](void* s) {
    rtcReleaseScene(static_cast<RTCScene>(s));
    rtcReleaseDevice(device);
  });
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
  for (const Vec3d& p : mesh.vertices)
    for (int k = 0; k < 3; ++k) *points++ = static_cast<float>(p[k]);
  auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.facets.size()));
  for (const auto& facet : mesh.facets)
    for (const VertexId v : facet) *corners++ = v;
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
}

void PeerRays::cast(std::span<const Ray> rays, std::span<float> distances) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray& ray = rays[i];
    RTCRayHit hit{};
    hit.ray.org_x = static_cast<float>(ray.point.x), hit.ray.dir_x = static_cast<float>(ray.direction.x);
    hit.ray.org_y = static_cast<float>(ray.point.y), hit.ray.dir_y = static_cast<float>(ray.direction.y);
    hit.ray.org_z = static_cast<float>(ray.point.z), hit.ray.dir_z = static_cast<float>(ray.direction.z);
    hit.ray.tnear = static_cast<float>(ray.from);
    hit.ray.tfar = std::numeric_limits<float>::infinity();
    hit.ray.mask = ~0U;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(static_cast<RTCScene>(scene_.get()), &context, &hit);
    distances[i] = hit.ray.tfar;
  }
}
#else
const bool PeerRays::here = false;
PeerRays::PeerRays(const TriangleMesh&) {}
void PeerRays::cast(std::span<const Ray>, std::span<float>) const {}
#endif

}  // namespace gabarit
