// Elementary functions with the same bits on every target: additions, multiplications, divisions
// and square roots in a fixed order, without the machine's mathematics library.
//
// All functions are templates over float, double and SIMD vectors of them (eagerx/simd.hpp), and
// have overloads for dual numbers (eagerx/math/dual.hpp), which give derivatives. They are written
// without branches over the vocabulary of math/vocabulary.hpp. They are constexpr: models compute
// their constants with them. Largest errors are in the docstrings, in units in the last place (ulp)
// of the exact result, as measured by tests/accuracy/measure.cpp; tests/unit/runtime/math_test.cpp
// guards them, tests/bits/ compares the bits across compilers and boards.
#pragma once

#include <eagerx/math/basic.hpp>
#include <eagerx/math/dual.hpp>
#include <eagerx/math/exponential.hpp>
#include <eagerx/math/hyperbolic.hpp>
#include <eagerx/math/inverse_trigonometric.hpp>
#include <eagerx/math/logarithm.hpp>
#include <eagerx/math/power.hpp>
#include <eagerx/math/rounding.hpp>
#include <eagerx/math/sqrt.hpp>
#include <eagerx/math/trigonometric.hpp>
#include <eagerx/math/vocabulary.hpp>
