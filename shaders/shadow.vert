#version 460
#extension GL_GOOGLE_include_directive : require
#include "draw.glsl"

layout(location = 0) in vec3 position;
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
layout(location = 5) in vec4 colour;

layout(location = 0) out vec4 out_uv;
layout(location = 1) out float out_alpha;

void main() {
  vec4 at = frame.shadow_from_eye * vec4(draw.eye_from_object * vec4(position, 1), 1);
  gl_Position = vec4(at.xy * 2 - 1, at.z, 1);
  if (features != 0) {
    out_uv = vec4(uv0, uv1);
    out_alpha = colour.a;
  }
}
