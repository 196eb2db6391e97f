// SPDX-License-Identifier: Apache-2.0
// The built-in names and functions whose values are numbers and vectors.
#include <cmath>
#include <limits>
#include <numbers>

#include "dioptre/core/expression_eval.h"
#include "dioptre/io/pov/function_compiler.h"
#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {

bool Interpreter::keyword_begins_expression(Keyword k) const {
  if (math_code(k)) return true;
  switch (k) {
    case Keyword::kX:
    case Keyword::kY:
    case Keyword::kZ:
    case Keyword::kU:
    case Keyword::kV:
    case Keyword::kT:
    case Keyword::kPi:
    case Keyword::kTrue:
    case Keyword::kYes:
    case Keyword::kOn:
    case Keyword::kFalse:
    case Keyword::kNo:
    case Keyword::kOff:
    case Keyword::kClock:
    case Keyword::kClockDelta:
    case Keyword::kClockOn:
    case Keyword::kInitialClock:
    case Keyword::kFinalClock:
    case Keyword::kInitialFrame:
    case Keyword::kFinalFrame:
    case Keyword::kFrameNumber:
    case Keyword::kImageWidth:
    case Keyword::kImageHeight:
    case Keyword::kVersion:
    case Keyword::kNow:
    case Keyword::kMin:
    case Keyword::kMax:
    case Keyword::kSelect:
    case Keyword::kBitwiseAnd:
    case Keyword::kBitwiseOr:
    case Keyword::kBitwiseXor:
    case Keyword::kDefined:
    case Keyword::kDimensions:
    case Keyword::kDimensionSize:
    case Keyword::kFileExists:
    case Keyword::kInside:
    case Keyword::kRand:
    case Keyword::kSeed:
    case Keyword::kStrcmp:
    case Keyword::kStrlen:
    case Keyword::kAsc:
    case Keyword::kVal:
    case Keyword::kVdot:
    case Keyword::kVlength:
    case Keyword::kVcross:
    case Keyword::kVrotate:
    case Keyword::kVaxisRotate:
    case Keyword::kVnormalize:
    case Keyword::kVturbulence:
    case Keyword::kTrace:
    case Keyword::kMinExtent:
    case Keyword::kMaxExtent:
      return true;
    default:
      return false;
  }
}

std::optional<double> Interpreter::built_in_variable(Keyword k) const {
  switch (k) {
    case Keyword::kClockDelta:
      return options_.clock_delta;
    case Keyword::kInitialClock:
      return options_.initial_clock;
    case Keyword::kFinalClock:
      return options_.final_clock;
    case Keyword::kInitialFrame:
      return options_.initial_frame;
    case Keyword::kFinalFrame:
      return options_.final_frame;
    case Keyword::kFrameNumber:
      return options_.frame_number;
    case Keyword::kImageWidth:
      return options_.image_width;
    case Keyword::kImageHeight:
      return options_.image_height;
    default:
      return std::nullopt;
  }
}

Numeric Interpreter::keyword_value(Keyword k) {
  const auto constant = [this](double v) {
    next();
    return number(v);
  };
  const auto axis = [this](std::size_t place, std::uint8_t size) {
    next();
    Numeric n;
    n.size = size;
    n.v[place] = 1;
    return n;
  };
  switch (k) {
    case Keyword::kX:
      return axis(0, 3);
    case Keyword::kY:
      return axis(1, 3);
    case Keyword::kZ:
      return axis(2, 3);
    case Keyword::kU:
      return axis(0, 2);
    case Keyword::kV:
      return axis(1, 2);
    case Keyword::kT:
      return axis(3, 4);
    case Keyword::kPi:
      return constant(std::numbers::pi);
    case Keyword::kTrue:
    case Keyword::kYes:
    case Keyword::kOn:
      return constant(1);
    case Keyword::kFalse:
    case Keyword::kNo:
    case Keyword::kOff:
      return constant(0);
    case Keyword::kClock:
      return constant(options_.clock);
    case Keyword::kClockOn:
      return constant(options_.clock_on);
    case Keyword::kVersion:
      return constant(version_);
    case Keyword::kNow:
      return constant(days_now());
    default:
      if (const auto v = built_in_variable(k)) return constant(*v);
  }
  if (!keyword_begins_expression(k)) {
    if (at_color_keyword()) return color_factor();
    fail_expected("a number or vector");
  }
  const Nesting guard(*this);
  next();
  if (k == Keyword::kDefined) return number(parse_defined());
  expect('(', "after the name of the function");
  const Numeric value = function_value(k);
  expect(')', "after the arguments");
  return value;
}

Numeric Interpreter::function_value(Keyword k) {
  if (const auto code = math_code(k)) return number(math(k, *code));
  switch (k) {
    case Keyword::kMin:
    case Keyword::kMax:
      return number(extremum(k));
    case Keyword::kSelect:
      return select();
    case Keyword::kBitwiseAnd:
    case Keyword::kBitwiseOr:
    case Keyword::kBitwiseXor:
      return number(bitwise(k));
    case Keyword::kDimensions:
      return number(dimension(false));
    case Keyword::kDimensionSize:
      return number(dimension(true));
    case Keyword::kFileExists:
      return number(access_.find(parse_file_name()).has_value());
    case Keyword::kInside:
      return number(inside());
    case Keyword::kRand:
      return number(random());
    case Keyword::kSeed:
      return number(seed());
    case Keyword::kStrcmp:
      return number(strings_compared());
    case Keyword::kStrlen:
      return number(static_cast<double>(parse_string().size()));
    case Keyword::kAsc: {
      const std::string text = parse_string();
      return number(text.empty() ? 0 : static_cast<unsigned char>(text[0]));
    }
    case Keyword::kVal:
      return number(std::strtod(parse_string().c_str(), nullptr));
    case Keyword::kVdot: {
      const Vec3 a = vector_argument();
      expect(',', "between the arguments");
      return number(dot(a, vector_argument()));
    }
    case Keyword::kVlength:
      return number(length(vector_argument()));
    case Keyword::kVcross: {
      const Vec3 a = vector_argument();
      expect(',', "between the arguments");
      return vector3(cross(a, vector_argument()));
    }
    case Keyword::kVrotate: {
      const Vec3 a = vector_argument();
      expect(',', "between the arguments");
      return vector3(rotation(vector_argument()).vector(a));
    }
    case Keyword::kVaxisRotate:
      return rotated_about_axis();
    case Keyword::kVnormalize: {
      const Vec3 a = vector_argument();
      const double size = length(a);
      return vector3(size > 0 ? a * (1 / size) : a);
    }
    case Keyword::kVturbulence:
      return turbulence_vector();
    case Keyword::kTrace:
      return trace();
    case Keyword::kMinExtent:
      return extent(false);
    default:
      return extent(true);
  }
}

double Interpreter::float_argument() {
  const SourcePosition where = position();
  return as_float(full(), where);
}

Vec3 Interpreter::vector_argument() {
  const Numeric n = promoted(full(), 3);
  return {n.v[0], n.v[1], n.v[2]};
}

Numeric Interpreter::rotated_about_axis() {
  const Vec3 a = vector_argument();
  expect(',', "between the arguments");
  const Vec3 axis = vector_argument();
  expect(',', "between the arguments");
  const double angle = float_argument();
  if (!(length(axis) > 0)) return vector3(a);
  return vector3(axis_rotation(axis, angle).vector(a));
}

/// A function of one or two numbers.
double Interpreter::math(Keyword k, Step::Code code) {
  const double a = float_argument();
  double b = 0;
  if (has_two_arguments(code)) {
    expect(',', "between the arguments");
    b = float_argument();
  }
  const std::string& name = symbols_.name(static_cast<Symbol>(k));
  if (code == Step::Code::kSqrt && a < 0) fail("sqrt of a negative number");
  if ((code == Step::Code::kAsin || code == Step::Code::kAcos) && !(std::fabs(a) <= 1)) {
    warn(name + " of a number outside -1 to 1");
    const double clipped = a > 1 ? 1 : a < -1 ? -1 : a;
    return evaluate_operator(code, clipped, b);
  }
  if ((code == Step::Code::kLn || code == Step::Code::kLog) && a <= 0) {
    fail(name + " of a number that is not positive");
  }
  if ((code == Step::Code::kMod || code == Step::Code::kDiv) && b == 0) {
    warn(name + " by zero");
    // Measured: scenes go on with these.
    return code == Step::Code::kMod ? -std::numeric_limits<double>::quiet_NaN() : INT32_MIN;
  }
  return evaluate_operator(code, a, b);
}

double Interpreter::extremum(Keyword k) {
  double value = float_argument();
  while (accept(',')) {
    const double other = float_argument();
    value = (k == Keyword::kMin) == (other < value) ? other : value;
  }
  return value;
}

double Interpreter::bitwise(Keyword k) {
  const auto integer = [this] {
    const double v = float_argument();
    return std::fabs(v) < 2147483648.0 ? static_cast<std::int32_t>(v)
                                       : (v < 0 ? INT32_MIN : INT32_MAX);
  };
  std::int32_t value = integer();
  while (accept(',')) {
    const std::int32_t other = integer();
    value = k == Keyword::kBitwiseAnd  ? value & other
            : k == Keyword::kBitwiseOr ? value | other
                                       : value ^ other;
  }
  return value;
}

Numeric Interpreter::select() {
  const double test = float_argument();
  expect(',', "between the arguments");
  const Numeric below = full();
  expect(',', "between the arguments");
  const Numeric zero = full();
  const Numeric above = accept(',') ? full() : zero;
  return test < 0 ? below : test > 0 ? above : zero;
}

/// Random streams: s = 1812433253 s + 12345 modulo 2^32, the value s / (2^32 - 1).
double Interpreter::seed() {
  const double v = float_argument();
  const bool fits = std::fabs(v) < 2147483648.0;
  streams_.push_back(fits ? static_cast<std::uint32_t>(static_cast<std::int32_t>(v)) : 0x80000000u);
  ++effects_;
  return static_cast<double>(streams_.size() - 1);
}

double Interpreter::random() {
  const double stream = float_argument();
  if (!(stream >= 0 && stream < static_cast<double>(streams_.size()))) {
    fail("rand needs a stream made by seed", "write #declare R = seed(1); and then rand(R)");
  }
  std::uint32_t& state = streams_[static_cast<std::size_t>(stream)];
  state = 1812433253u * state + 12345u;
  ++effects_;
  return state / 4294967295.0;
}

/// Of an array: how many dimensions, or how long one of them (from 1) is.
double Interpreter::dimension(bool size) {
  const Value* value = operand();
  const Array* array = value ? get_if<Array>(*value) : nullptr;
  if (!array) fail_expected("the name of an array");
  const std::vector<std::uint32_t> sizes = array->sizes;
  next();
  if (!size) return static_cast<double>(sizes.size());
  expect(',', "between the arguments");
  const double which = std::trunc(float_argument());
  if (!(which >= 1 && which <= static_cast<double>(sizes.size()))) return 0;
  return sizes[static_cast<std::size_t>(which) - 1];
}

ObjectId Interpreter::object_argument() {
  const SourcePosition where = position();
  const DescribedPtr described = take_described();
  const Object* object = described ? std::get_if<Object>(described.get()) : nullptr;
  if (!object) fail_expected("the name of an object");
  const auto* whole = std::get_if<Csg>(&object->geometry);
  if (whole && whole->children.empty()) {
    warn_once(where, "there is nothing in '" + last_name_ + "' that is rendered: no ray meets it");
  }
  return registered(described, *object);
}

/// An object is put into the scene once for all questions about it.
ObjectId Interpreter::registered(const DescribedPtr& described, const Object& object) {
  const auto known = questioned_.find(described.get());
  if (known != questioned_.end()) return known->second.id;
  const ObjectId id = register_object(*this, object);
  questioned_.emplace(described.get(), Questioned{described, id});
  return id;
}

double Interpreter::inside() {
  const ObjectId object = object_argument();
  expect(',', "between the arguments");
  return queries().inside(scene_, object, vector_argument());
}

Numeric Interpreter::extent(bool upper) {
  const Bounds bounds = queries().extent(scene_, object_argument());
  const auto limited = [](double v) { return std::fmax(-1e10, std::fmin(1e10, v)); };
  const Vec3 corner = upper ? bounds.max : bounds.min;
  return vector3({limited(corner.x), limited(corner.y), limited(corner.z)});
}

/// The hit point; the fourth argument names what is to get the normal.
Numeric Interpreter::trace() {
  const ObjectId object = object_argument();
  expect(',', "between the arguments");
  const Vec3 origin = vector_argument();
  expect(',', "between the arguments");
  const Vec3 direction = vector_argument();
  std::optional<SceneQueries::Hit> hit;
  if (length(direction) > 0 && is_finite(origin) && is_finite(direction)) {
    hit = queries().trace(scene_, object, {origin, direction});
  }
  if (accept(',')) {
    Target target = parse_target(false);
    ready_ = false;
    assign(target, vector3(hit ? hit->normal : Vec3{}));
  }
  return vector3(hit ? hit->position : Vec3{});
}

}  // namespace dioptre::pov
