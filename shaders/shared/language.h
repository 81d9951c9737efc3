// What lets one header be read by C++ and by GLSL: the same names for types, `scalar` layout on both sides.
#ifndef UNGHOST_SHARED_LANGUAGE_H
#define UNGHOST_SHARED_LANGUAGE_H

#ifdef __cplusplus
#include <cstdint>

#include <glm/glm.hpp>

#define SHARED_BEGIN namespace unghost {
#define SHARED_END }
#define SHARED_CONSTANT inline constexpr uint32_t
#define SHARED_NUMBER inline constexpr float
#define SHARED_FUNCTION inline
namespace unghost {
using uint = uint32_t;
using glm::ivec2, glm::uvec2, glm::vec2, glm::vec3, glm::vec4, glm::mat3, glm::mat4, glm::mat3x2, glm::mat4x3;
}
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_CONSTANT const uint
#define SHARED_NUMBER const float
#define SHARED_FUNCTION
#endif

#endif
