#include "renderer/scene/gltf_topology.h"

namespace unghost::gltf {

std::vector<uint32_t> triangle_list(Topology topology, std::span<const uint32_t> indices) {
  const size_t n = indices.size();
  if (topology == Topology::triangles) return {indices.begin(), indices.begin() + ptrdiff_t(n / 3 * 3)};
  std::vector<uint32_t> out;
  if (n < 3 || (topology != Topology::strip && topology != Topology::fan)) return out;
  out.reserve((n - 2) * 3);
  for (size_t i = 0; i + 2 < n; ++i) {
    if (topology == Topology::strip) { // glTF 2.0, 3.7.2.1: p_i = {v_i, v_(i+1+i%2), v_(i+2-i%2)}
      out.insert(out.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
    } else { // p_i = {v_(i+1), v_(i+2), v_0}
      out.insert(out.end(), {indices[i + 1], indices[i + 2], indices[0]});
    }
  }
  return out;
}

} // namespace unghost::gltf
