#version 460
#extension GL_GOOGLE_include_directive : require
#include "draw.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
layout(location = 5) in vec4 colour;

layout(location = 0) out vec3 out_normal;
layout(location = 1) out vec4 out_tangent;
layout(location = 2) out vec4 out_uv;
layout(location = 3) out vec4 out_colour;
layout(location = 4) out vec3 out_previous_eye;

void main() {
  mat3 m = mat3(draw.eye_from_object);
  gl_Position = frame.clip_from_eye * vec4(draw.eye_from_object * vec4(position, 1), 1);
  // cofactors: what is flattened has no inverse, and still knows where its normals point
  vec3 cofactor = cross(m[1], m[2]);
  float side = dot(m[0], cofactor) < 0 ? -1.0 : 1.0;
  out_normal = mat3(cofactor, cross(m[2], m[0]), cross(m[0], m[1])) * normal * side;
  out_tangent = vec4(m * tangent.xyz, tangent.w * side);
  out_uv = vec4(uv0, uv1);
  out_colour = colour;
  out_previous_eye = moved ? previous_eye_from_object[gl_InstanceIndex] * vec4(position, 1) : vec3(0);
}
