// How a window's picture is composed out of the pictures of a frame's modes: what C++ lays out, the shader draws.
#ifndef UNGHOST_SHARED_SCREEN_H
#define UNGHOST_SHARED_SCREEN_H

#include "language.h"

// single: the first mode alone. split: the first to the left of a bar, the second to its right, of the same picture.
// grid: up to four whole pictures. difference: between the first and the second, the largest of a channel, times
// SCREEN_DIFFERENCE_GAIN. flip: FLIP of the same two, the error that somebody sees who flips between them.
#define UNGHOST_ARRANGEMENTS(X)                                                                              \
  X(arrangement, single, 0) X(arrangement, split, 1) X(arrangement, grid, 2) X(arrangement, difference, 3) \
  X(arrangement, flip, 4)

SHARED_BEGIN

SHARED_CONSTANT SCREEN_PICTURE_0 = 0;
SHARED_CONSTANT SCREEN_PICTURE_1 = 1;
SHARED_CONSTANT SCREEN_PICTURE_2 = 2;
SHARED_CONSTANT SCREEN_PICTURE_3 = 3;
SHARED_CONSTANT SCREEN_ERROR = 4;
SHARED_CONSTANT SCREEN_OUT = 5;
SHARED_CONSTANT SCREEN_PICTURES = 4;

/// What is seen of the pictures.
SHARED_CONSTANT SCREEN_SHOWS_PICTURE = 0;
SHARED_CONSTANT SCREEN_SHOWS_DIFFERENCE = 1;
SHARED_CONSTANT SCREEN_SHOWS_ERROR = 2;

/// How a picture comes to the size at which it is shown.
SHARED_CONSTANT SCREEN_COPIED = 0;
SHARED_CONSTANT SCREEN_ENLARGED = 1;
SHARED_CONSTANT SCREEN_REDUCED = 2;

/// An invocation does so many pixels above one another, which share the rows of the picture that they are made from.
SHARED_CONSTANT SCREEN_ROWS = 4;
SHARED_CONSTANT SCREEN_DIFFERENCE_GAIN = 8;
/// Around the magnifier: light, then dark, so that it is seen before anything. Around its region one of each.
SHARED_CONSTANT SCREEN_LIGHT_BORDER = 2;
SHARED_CONSTANT SCREEN_BORDER = 3;
SHARED_CONSTANT SCREEN_OUTLINE = 2;

/// Whole pixels, from the top left.
struct ScreenRect {
  int x, y, width, height;
};

/// One picture's part of the window. All in the window's pixels, but where it says otherwise.
struct ScreenPush {
  ScreenRect covered;  // what is drawn
  ScreenRect shown;    // of it, what the picture is seen in
  ScreenRect picture;  // where the whole picture would be
  ScreenRect inset;    // of the magnifier
  ScreenRect region;   // what is magnified
  ivec2 region_px;     // its corner, in the picture's pixels
  ivec2 region_at;     // where that corner lies in the magnifier, or beside it where the magnifier is cropped
  ivec2 picture_px;    // size of the picture
  int block;           // pixels along each side, of a magnified one
  float beside;        // grey, where no picture is seen
};

SHARED_END

#endif
