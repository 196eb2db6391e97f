// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace dioptre {
namespace enum_names {

/// Enumerators are looked for among the values 0 to kLimit - 1.
inline constexpr int kLimit = 64;

/// The spelling of an enumerator, "kBilinear", as the compiler prints it in the name of this
/// function; empty if the value names no enumerator.
template <auto value>
constexpr std::string_view spelling() {
  const std::string_view function = __PRETTY_FUNCTION__;
  const std::size_t start = function.find("value = ") + 8;
  std::string_view text = function.substr(start, function.find_first_of(";]", start) - start);
  if (text.front() == '(') return {};
  if (const std::size_t colon = text.rfind(':'); colon != std::string_view::npos) {
    text.remove_prefix(colon + 1);
  }
  return text;
}

template <class Enum, int... values>
constexpr auto spellings(std::integer_sequence<int, values...>) {
  return std::array<std::string_view, sizeof...(values)>{spelling<static_cast<Enum>(values)>()...};
}

template <class Enum>
inline constexpr auto kSpellings = spellings<Enum>(std::make_integer_sequence<int, kLimit>());

/// "kNormalizedDistance" as "normalized_distance".
inline std::string to_snake_case(std::string_view spelling) {
  std::string name;
  for (const char c : spelling.substr(1)) {
    const bool upper = c >= 'A' && c <= 'Z';
    if (upper && !name.empty()) name.push_back('_');
    name.push_back(upper ? static_cast<char>(c - 'A' + 'a') : c);
  }
  return name;
}

}  // namespace enum_names

/// The name of an enumerator in files: kNormalizedDistance is "normalized_distance". Nothing if the
/// value is no enumerator.
template <class Enum>
std::optional<std::string> enum_name(Enum value) {
  const auto index = static_cast<long>(value);
  if (index < 0 || index >= enum_names::kLimit) return std::nullopt;
  const std::string_view spelling = enum_names::kSpellings<Enum>[static_cast<std::size_t>(index)];
  if (spelling.empty()) return std::nullopt;
  return enum_names::to_snake_case(spelling);
}

/// The enumerator of a name, if there is one.
template <class Enum>
std::optional<Enum> enum_value(std::string_view name) {
  for (int index = 0; index < enum_names::kLimit; ++index) {
    if (enum_name(static_cast<Enum>(index)) == name) return static_cast<Enum>(index);
  }
  return std::nullopt;
}

}  // namespace dioptre
