// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "dioptre/io/pov/lexer.h"
#include "dioptre/io/pov/parser.h"
#include "dioptre/io/pov/spline.h"

namespace dioptre::pov {

struct Array;
struct Macro;
struct FunctionValue;
struct TextFile;

/// What an identifier stands for. The parts of strings, arrays and described things are shared
/// between copies; arrays are copied when one of the sharers changes.
using Value = std::variant<std::monostate, Numeric, std::shared_ptr<const std::string>,
                           std::shared_ptr<Array>, std::shared_ptr<const Macro>,
                           std::shared_ptr<const FunctionValue>, std::shared_ptr<const Spline>,
                           std::shared_ptr<TextFile>, DescribedPtr>;

inline bool is_set(const Value& value) { return value.index() != 0; }
template <class T>
const T* get_if(const Value& value) {
  const auto* pointer = std::get_if<std::shared_ptr<T>>(&value);
  return pointer ? pointer->get() : nullptr;
}

/// An array of one or more dimensions, row by row; elements may be unset.
struct Array {
  std::vector<std::uint32_t> sizes;
  std::vector<Value> elements;
  std::uint32_t depth = 1;  ///< at least how many arrays lie within each other
};

/// A macro: a place in a program.
struct Macro {
  Symbol name = 0;
  std::vector<Symbol> parameters;
  const Program* program = nullptr;
  std::uint32_t body = 0;  ///< the first token after the parameters
  std::uint32_t end = 0;   ///< its #end
  SourcePosition position;
};

/// A user function: of one number (one component), or of a vector or colour.
struct FunctionValue {
  std::vector<std::string> parameters;
  std::vector<FunctionId> components;  ///< a number: one; a vector: one for each
  PigmentId pigment;                   ///< of a colour function, else none
  FunctionId gray;                     ///< of a colour function, else none
  bool internal = false;  ///< a built-in one, which knows itself how many parameters it has
  std::shared_ptr<const Spline> spline;  ///< of a spline's function, else none
};

/// A number of n equal components.
inline Numeric number(double v) {
  Numeric n;
  n.v[0] = v;
  return n;
}
inline Numeric vector3(Vec3 v) {
  Numeric n;
  n.size = 3;
  n.v = {v.x, v.y, v.z, 0, 0};
  return n;
}
/// A number becomes a vector of that number; a vector is filled up with zeros or cut.
inline Numeric promoted(Numeric n, std::uint8_t size) {
  if (n.size == 1) {
    for (std::uint8_t i = 1; i < size; ++i) n.v[i] = n.v[0];
  } else {
    for (std::uint8_t i = n.size; i < size; ++i) n.v[i] = 0;
  }
  n.size = size;
  return n;
}

/// What a number becomes once it is kept under a name: five components are a colour, and colours
/// are of single precision (measured).
inline Numeric stored(Numeric n) {
  if (n.size < 5) return n;
  for (double& v : n.v) v = static_cast<float>(v);
  return n;
}

}  // namespace dioptre::pov
