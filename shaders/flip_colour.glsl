// The colours of FLIP: linear light as a share of white's X, Y and Z.
#ifndef UNGHOST_FLIP_COLOUR_GLSL
#define UNGHOST_FLIP_COLOUR_GLSL

#include "shared/flip.h"

vec3 xyz_over_white(vec3 c) {
  return vec3(dot(vec3(FLIP_X_OF_RED, FLIP_X_OF_GREEN, FLIP_X_OF_BLUE), c),
              dot(vec3(FLIP_Y_OF_RED, FLIP_Y_OF_GREEN, FLIP_Y_OF_BLUE), c),
              dot(vec3(FLIP_Z_OF_RED, FLIP_Z_OF_GREEN, FLIP_Z_OF_BLUE), c));
}

#endif
