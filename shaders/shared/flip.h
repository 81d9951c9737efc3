// The numbers of FLIP (Andersson et al. 2020) as NVIDIA's program has them, for the processor that measures
// by it and the device that shows it; and how the device's passes filter. Its filters come from
// renderer/flip_filters.h.
#ifndef UNGHOST_SHARED_FLIP_H
#define UNGHOST_SHARED_FLIP_H

#include "language.h"

SHARED_BEGIN

// Linear sRGB as XYZ over the white of D65, and that white.
SHARED_NUMBER FLIP_WHITE_X = 0.950428545f, FLIP_WHITE_Z = 1.088900371f;
SHARED_NUMBER FLIP_X_OF_RED = float(10135552.0 / 24577794.0 / 0.950428545);
SHARED_NUMBER FLIP_X_OF_GREEN = float(8788810.0 / 24577794.0 / 0.950428545);
SHARED_NUMBER FLIP_X_OF_BLUE = float(4435075.0 / 24577794.0 / 0.950428545);
SHARED_NUMBER FLIP_Y_OF_RED = float(2613072.0 / 12288897.0);
SHARED_NUMBER FLIP_Y_OF_GREEN = float(8788810.0 / 12288897.0);
SHARED_NUMBER FLIP_Y_OF_BLUE = float(887015.0 / 12288897.0);
SHARED_NUMBER FLIP_Z_OF_RED = float(1425312.0 / 73733382.0 / 1.088900371);
SHARED_NUMBER FLIP_Z_OF_GREEN = float(8788810.0 / 73733382.0 / 1.088900371);
SHARED_NUMBER FLIP_Z_OF_BLUE = float(70074185.0 / 73733382.0 / 1.088900371);
// And back, to what a screen shows.
SHARED_NUMBER FLIP_RED_OF_X = 3.241003275f, FLIP_RED_OF_Y = -1.537398934f, FLIP_RED_OF_Z = -0.498615861f;
SHARED_NUMBER FLIP_GREEN_OF_X = -0.969224334f, FLIP_GREEN_OF_Y = 1.875930071f, FLIP_GREEN_OF_Z = 0.041554224f;
SHARED_NUMBER FLIP_BLUE_OF_X = 0.055639423f, FLIP_BLUE_OF_Y = -0.204011202f, FLIP_BLUE_OF_Z = 1.057148933f;

SHARED_NUMBER FLIP_LAB_DELTA = 6.0f / 29.0f;
SHARED_NUMBER FLIP_HUNT = 0.01f;             // how much lightness makes of colours
SHARED_NUMBER FLIP_DISTANCE_POWER = 0.7f;    // of colours
SHARED_NUMBER FLIP_KNEE = 0.4f;              // of the largest distance; errors rise steeply below it
SHARED_NUMBER FLIP_AT_KNEE = 0.95f;          // the error there
SHARED_NUMBER FLIP_ABOVE_KNEE = 0.05f;       // the rest
SHARED_NUMBER FLIP_LIGHTNESS_RANGE = 116.0f; // of what features are found in
SHARED_NUMBER FLIP_FEATURE_SHARE = 0.707106781f;

/// Half of the device's filters: as far as those of the usual monitor reach. A tap has a weight of each
/// filter.
SHARED_CONSTANT FLIP_TAPS = 11;
SHARED_CONSTANT FLIP_FILTERS = 7;

/// An invocation filters a band of a column, then of a row, and keeps what its filters see meanwhile; so many
/// at a time.
SHARED_CONSTANT FLIP_BAND_ROWS = 32;
SHARED_CONSTANT FLIP_BAND_COLUMNS = 32;
SHARED_CONSTANT FLIP_BATCH = 4;
SHARED_CONSTANT FLIP_GROUP_BANDS = 8;
SHARED_CONSTANT FLIP_GROUP_ROWS = 8;

SHARED_CONSTANT FLIP_DISPLAY = 0;
SHARED_CONSTANT FLIP_COLOURS = 1;
SHARED_CONSTANT FLIP_FEATURES = 2;
SHARED_CONSTANT FLIP_TEST_COLOURS = 3;
SHARED_CONSTANT FLIP_TEST_FEATURES = 4;
SHARED_CONSTANT FLIP_OUT = 5;

SHARED_END

#endif
