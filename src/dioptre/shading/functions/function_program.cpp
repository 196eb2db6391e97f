// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/functions/function_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dioptre/core/expression_eval.h"
#include "dioptre/shading/functions/function_table.h"
#include "dioptre/shading/noise/noise.h"
#include "dioptre/shading/noise/noise_bounds.h"

namespace dioptre {
namespace {

/// Room for the registers of one run: on the stack if they are few.
template <class T>
class Registers {
 public:
  explicit Registers(std::size_t count) {
    if (count <= kFew) return;
    many_ = std::make_unique_for_overwrite<T[]>(count);
    first_ = many_.get();
  }
  T* get() { return first_; }

 private:
  static constexpr std::size_t kFew = 96;
  struct Raw {
    alignas(T) std::array<std::byte, kFew * sizeof(T)> bytes;
  };
  Raw few_;
  std::unique_ptr<T[]> many_;
  T* first_ = reinterpret_cast<T*>(few_.bytes.data());
};

constexpr std::size_t kMostArguments = 64;

}  // namespace

FunctionProgram::FunctionProgram(Code code, const FunctionTable& table)
    : code_(std::move(code)),
      table_(table),
      first_result_(static_cast<std::uint32_t>(code_.constants.size()) + code_.parameter_count),
      register_count_(first_result_ + code_.instructions.size()) {}

double FunctionProgram::value(std::span<const double> arguments) const {
  Registers<double> registers(register_count_);
  double* next = std::copy(code_.constants.begin(), code_.constants.end(), registers.get());
  for (std::uint32_t k = 0; k < code_.parameter_count; ++k) {
    *next++ = k < arguments.size() ? arguments[k] : 0;
  }
  run(registers.get());
  return registers.get()[code_.result];
}

void FunctionProgram::run(double* registers) const {
  double* out = registers + first_result_;
  for (const Instruction& i : code_.instructions) {
    switch (i.kind) {
      case Kind::kOperator:
        *out = evaluate_operator(i.code, registers[i.a], registers[i.b]);
        break;
      case Kind::kSquare:
        *out = registers[i.a] * registers[i.a];
        break;
      case Kind::kNorm: {
        const double x = registers[i.a], y = registers[i.b], z = registers[i.c];
        *out = std::sqrt(x * x + y * y + z * z);
        break;
      }
      case Kind::kSelect: {
        const double sign = registers[i.a];
        *out = registers[sign < 0 ? i.b : sign > 0 ? i.extra : i.c];
        break;
      }
      case Kind::kNoise:
        *out = noise({registers[i.a], registers[i.b], registers[i.c]},
                     static_cast<NoiseGenerator>(i.extra));
        break;
      case Kind::kCall:
        *out = call(i, registers);
        break;
      case Kind::kLoop:
        *out = loop(i, registers);
        break;
    }
    ++out;
  }
}

double FunctionProgram::call(const Instruction& i, const double* registers) const {
  std::array<double, kMostArguments> arguments;
  const std::size_t count = std::min<std::size_t>(i.b, arguments.size());
  for (std::size_t k = 0; k < count; ++k) arguments[k] = registers[code_.arguments[i.a + k]];
  return table_.call(i.function, {arguments.data(), count});
}

double FunctionProgram::loop(const Instruction& i, const double* registers) const {
  std::array<double, kMostArguments> arguments;
  const std::size_t count = std::min<std::size_t>(i.extra, arguments.size());
  for (std::size_t k = 0; k < count; ++k) arguments[k] = registers[code_.arguments[i.c + k]];
  Step step;
  step.code = i.code;
  step.function = i.function;
  const auto call = [this](FunctionId id, std::span<const double> inner) {
    return table_.call(id, inner);
  };
  return detail::accumulate_rounds(step, {arguments.data(), count}, registers[i.a], registers[i.b],
                                   call);
}

IntervalJet FunctionProgram::range(std::span<const IntervalJet> arguments) const {
  Registers<IntervalJet> registers(register_count_);
  IntervalJet* next = registers.get();
  for (const double c : code_.constants) *next++ = IntervalJet::constant(c);
  for (std::uint32_t k = 0; k < code_.parameter_count; ++k) {
    *next++ = k < arguments.size() ? arguments[k] : IntervalJet::constant(0);
  }
  run(registers.get());
  return registers.get()[code_.result];
}

void FunctionProgram::run(IntervalJet* registers) const {
  IntervalJet* out = registers + first_result_;
  for (const Instruction& i : code_.instructions) {
    switch (i.kind) {
      case Kind::kOperator:
        *out = evaluate_operator(i.code, registers[i.a], registers[i.b]);
        break;
      case Kind::kSquare: {
        const IntervalJet& a = registers[i.a];
        *out = {square(a.value), (a.value + a.value) * a.slope};
        break;
      }
      case Kind::kNorm:
        *out = norm(registers[i.a], registers[i.b], registers[i.c]);
        break;
      case Kind::kSelect:
        *out = select(registers[i.a], registers[i.b], registers[i.c], registers[i.extra]);
        break;
      case Kind::kNoise:
        *out = noise_range(registers[i.a], registers[i.b], registers[i.c],
                           static_cast<NoiseGenerator>(i.extra));
        break;
      case Kind::kCall:
        *out = {table_.range_of(i.function), Interval::all()};
        break;
      case Kind::kLoop:
        *out = IntervalJet::everything();
        break;
    }
    ++out;
  }
}

}  // namespace dioptre
