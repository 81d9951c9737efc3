// The size of a full-screen pass's workgroups, in pixels.
#ifndef UNGHOST_SHARED_WORKGROUP_H
#define UNGHOST_SHARED_WORKGROUP_H

#include "language.h"

SHARED_BEGIN
// Rows: a software device's lanes then load from one line of a picture, and a GPU's too.
SHARED_CONSTANT WORKGROUP_WIDTH = 64;
SHARED_CONSTANT WORKGROUP_HEIGHT = 1;
// The naive resolve is what one writes first: squares.
SHARED_CONSTANT TAA_NAIVE_SIDE = 8;
// The fast resolve: an invocation does pixels above one another, so that they share the rows of their neighbourhoods.
SHARED_CONSTANT TAA_ROWS = 4;
SHARED_CONSTANT TAA_GROUP_WIDTH = 64;
SHARED_CONSTANT TAA_GROUP_HEIGHT = TAA_ROWS;
SHARED_END

#endif
