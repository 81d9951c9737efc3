// The size of a full-screen pass's workgroups, in pixels.
#ifndef UNGHOST_SHARED_WORKGROUP_H
#define UNGHOST_SHARED_WORKGROUP_H

#include "language.h"

SHARED_BEGIN
SHARED_CONSTANT WORKGROUP_WIDTH = 8;
SHARED_CONSTANT WORKGROUP_HEIGHT = 8;
SHARED_END

#endif
