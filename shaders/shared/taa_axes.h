// Axes of discrete oriented polytopes: a k-DOP has k/2, each with an extent on either side (Klosowski et al. 1998;
// Ikkala et al. 2024). X(x, y, z) for each; lists, so that shaders unroll them and C++ tests read the same numbers.
#ifndef UNGHOST_SHARED_TAA_AXES_H
#define UNGHOST_SHARED_TAA_AXES_H

#define TAA_AXES_XYZ(X) X(1.0, 0.0, 0.0) X(0.0, 1.0, 0.0) X(0.0, 0.0, 1.0)

// Ikkala et al. 2024, supplement: tightest around the unit sphere.
#define TAA_AXES_DOP32(X)                                                                                    \
  TAA_AXES_XYZ(X)                                                                                            \
  X(.820081, .456727, -.344773) X(.540295, .829202, .143195) X(.255800, .841084, -.476597)                   \
  X(-.406935, -.389062, .826459) X(-.826708, -.382923, -.412219) X(.260942, -.577482, .773578)               \
  X(.254398, .637821, .726957) X(.310900, -.728083, -.610930) X(.798513, -.556827, -.228738)                 \
  X(.673383, -.163602, -.720964) X(-.813922, .369658, -.448201) X(.477650, -.853722, .207384)                \
  X(-.554854, -.041550, -.830910)

// The same paper's, for its scenes of grass and of asphalt.
#define TAA_AXES_DOP16_GRASS(X)                                                                              \
  X(-.663315, .729578, -.166518) X(.575024, -.084585, -.813753) X(-.158262, .489372, -.857594)               \
  X(.256166, -.038665, -.965859) X(.640264, -.436421, -.632138) X(-.813891, .466034, .346978)                \
  X(-.831598, -.215117, -.512025) X(.488190, -.812612, .318327)
#define TAA_AXES_DOP16_ASPHALT(X)                                                                            \
  X(.997167, -.054820, .051500) X(.043682, -.727663, .684542) X(-.451553, .808335, -.377751)                 \
  X(-.003001, .615645, -.788018) X(.130192, -.063137, -.989476) X(.775079, -.584236, -.240668)               \
  X(.589837, .171644, -.789070) X(.898010, -.436338, -.056459)

// Ours: `unghost axes --faces 16`, `--faces 22`, and for the neighbourhoods of our own asphalt
// `unghost axes --faces 16 --of-scene --size 640x360`.
#define TAA_AXES_DOP16(X)                                                                                    \
  TAA_AXES_XYZ(X)                                                                                            \
  X(-0.558083, -0.588055, -0.585435) X(0.557489, -0.590946, -0.583086) X(-0.017008, -0.700624, 0.713328)     \
  X(-0.717245, 0.494998, -0.490444) X(0.729939, 0.480927, -0.485694)
#define TAA_AXES_DOP22(X)                                                                                    \
  TAA_AXES_XYZ(X)                                                                                            \
  X(0.012396, 0.662737, -0.748750) X(-0.659216, 0.667743, 0.345766) X(0.659736, 0.041925, 0.750327)          \
  X(0.661755, 0.643261, -0.385091) X(0.652606, -0.641113, 0.403831) X(0.009181, -0.667165, -0.744853)        \
  X(0.664326, -0.026420, -0.746976) X(0.651802, 0.672001, 0.351523)
#define TAA_AXES_DOP16_OURS(X)                                                                               \
  X(-0.040082, 0.765695, -0.641953) X(-0.651689, -0.494198, 0.575387) X(-0.703102, 0.710754, -0.021830)      \
  X(-0.822285, 0.565948, 0.059588) X(-0.002357, -0.705181, 0.709023) X(0.876299, -0.417605, -0.240221)       \
  X(-0.037951, -0.361420, 0.931630) X(-0.727553, 0.210903, 0.652829)

/// The lists by the answer that asks for them.
#define TAA_AXIS_LISTS(LIST)                                                                                 \
  LIST(xyz, TAA_AXES_XYZ) LIST(dop16, TAA_AXES_DOP16) LIST(dop22, TAA_AXES_DOP22) LIST(dop32, TAA_AXES_DOP32) \
  LIST(dop16_grass, TAA_AXES_DOP16_GRASS) LIST(dop16_asphalt, TAA_AXES_DOP16_ASPHALT)                        \
  LIST(dop16_ours, TAA_AXES_DOP16_OURS)

#ifndef __cplusplus
/// AXIS(x, y, z), which whoever asks defines, for each of the axes that the resolve is made with.
#define TAA_AXES_CASE(answer, list) case axes_##answer: { list(AXIS) } break;
#define TAA_EACH_AXIS switch (axes) { TAA_AXIS_LISTS(TAA_AXES_CASE) }
#endif

#endif
