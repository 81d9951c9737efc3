// Matplotlib's magma (van der Walt and Smith, CC0), as a polynomial.
#ifndef UNGHOST_SHARED_MAGMA_H
#define UNGHOST_SHARED_MAGMA_H

/// From the sixth degree down to the constant, red, green and blue. A fit by Matt Zucker (2019, CC0); off by at most 4 of
/// 255, and a little below zero at zero.
#define MAGMA_TERMS(X)                                                                                       \
  X(18.65570506591883, -11.48977351997711, -5.601961508734096)                                               \
  X(-50.76852536473588, 29.04658282127291, 4.23415299384598)                                                 \
  X(52.17613981234068, -27.94360607168351, 12.94416944238394)                                                \
  X(-27.66873308576866, 14.26473078096533, -13.64921318813922)                                               \
  X(8.353717279216625, -3.577719514958484, 0.3144679030132573)                                               \
  X(0.2516605407371642, 0.6775232436837668, 2.494026599312351)                                               \
  X(-0.002136485053939582, -0.000749655052795221, -0.005386127855323933)

#endif
