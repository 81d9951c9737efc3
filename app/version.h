// The version, which the build takes from CMake's project().
#pragma once

#ifndef UNGHOST_VERSION
#error "the build defines UNGHOST_VERSION"
#endif
