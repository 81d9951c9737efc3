// The pixels above one another that an invocation of the fast resolve does.
#ifndef UNGHOST_TAA_COLUMN_GLSL
#define UNGHOST_TAA_COLUMN_GLSL

#include "shared/workgroup.h"
#include "taa_pixel.glsl"

const int R = int(TAA_ROWS), COLUMN = R + 2;  // with a row above and one below

#endif
