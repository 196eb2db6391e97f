// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "dioptre/core/color.h"
#include "dioptre/core/fields.h"
#include "dioptre/core/id.h"
#include "dioptre/core/shared.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/enum_names.h"

namespace dioptre::json {

using Json = nlohmann::ordered_json;

inline Json from_number(double v) {
  if (std::isnan(v)) return "nan";
  if (std::isinf(v)) return v > 0 ? "inf" : "-inf";
  return v;
}

inline Json to_json(bool v) { return v; }
inline Json to_json(double v) { return from_number(v); }
inline Json to_json(float v) { return from_number(v); }
inline Json to_json(std::uint8_t v) { return v; }
inline Json to_json(std::uint32_t v) { return v; }
inline Json to_json(std::int32_t v) { return v; }
/// Text that is not UTF-8 could not be written; its bytes are kept as U+0000 to U+00FF and marked.
Json to_json(const std::string& v);
inline Json to_json(Vec2 v) { return Json::array({from_number(v.x), from_number(v.y)}); }
inline Json to_json(Vec3 v) {
  return Json::array({from_number(v.x), from_number(v.y), from_number(v.z)});
}
inline Json to_json(Color c) {
  return Json::array({from_number(c.r), from_number(c.g), from_number(c.b)});
}
inline Json to_json(PigmentColor c) {
  Json out = to_json(c.color);
  out.push_back(from_number(c.filter));
  out.push_back(from_number(c.transmit));
  return out;
}
template <class T>
Json to_json(Id<T> id) {
  return id ? Json(id.index) : Json();
}
template <class Enum>
requires std::is_enum_v<Enum> Json to_json(Enum v) {
  const auto name = enum_name(v);
  return name ? Json(*name) : Json(static_cast<int>(v));
}

template <class T>
Json to_json(const Shared<T>& v);
template <class T>
Json to_json(const std::vector<T>& v);
template <class T, std::size_t N>
Json to_json(const std::array<T, N>& v);
template <class... T>
Json to_json(const std::variant<T...>& v);
template <HasFields T>
Json to_json(const T& v);

template <class T>
Json to_json(const Shared<T>& v) {
  return to_json(*v);
}
template <class T>
Json to_json(const std::vector<T>& v) {
  Json out = Json::array();
  for (const auto& element : v) out.push_back(to_json(element));
  return out;
}
template <class T, std::size_t N>
Json to_json(const std::array<T, N>& v) {
  Json out = Json::array();
  for (const auto& element : v) out.push_back(to_json(element));
  return out;
}
template <class... T>
Json to_json(const std::variant<T...>& v) {
  return std::visit([](const auto& alternative) { return to_json(alternative); }, v);
}
template <HasFields T>
Json to_json(const T& v) {
  Json out = Json::object();
  if constexpr (Named<T>) out["type"] = T::kName;
  T::fields(v, [&](const char* name, const auto& field) { out[name] = to_json(field); });
  return out;
}

}  // namespace dioptre::json
