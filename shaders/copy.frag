#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/bindings.h"

layout(set = 0, binding = COPY_COLOUR) uniform texture2D colour_map;
layout(location = 0) out vec4 colour;

void main() { colour = texelFetch(colour_map, ivec2(gl_FragCoord.xy), 0); }
