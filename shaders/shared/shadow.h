// How the light pass reads the shadow map, and so how far beyond a caster its shadow changes light. In texels.
#ifndef UNGHOST_SHARED_SHADOW_H
#define UNGHOST_SHARED_SHADOW_H

#include "language.h"

SHARED_BEGIN

/// A surface is looked up so far above itself, or it would throw its shadow on itself.
SHARED_NUMBER SHADOW_OFFSET_TEXELS = 1.8f;
/// A texel of which the middle is nearer than this along both sides may be among those that a lookup compares with: four
/// in a row, of which the two in the middle lie around it.
SHARED_CONSTANT SHADOW_FILTER_TEXELS = 2;
/// What casts a shadow further away than this takes no part in it, whichever way a surface faces.
SHARED_NUMBER SHADOW_REACH_TEXELS = SHADOW_OFFSET_TEXELS + SHADOW_FILTER_TEXELS;

SHARED_END

#endif
