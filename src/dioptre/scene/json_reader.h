// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
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

/// Turns JSON into scene data. The first problem is kept, with its place; after one, results mean
/// nothing.
class Reader {
 public:
  bool good() const { return problem_.empty(); }
  const std::string& problem() const { return problem_; }

  void read(const Json& json, bool& v);
  void read(const Json& json, double& v);
  void read(const Json& json, float& v);
  void read(const Json& json, std::uint8_t& v) { read_integer(json, v); }
  void read(const Json& json, std::uint32_t& v) { read_integer(json, v); }
  void read(const Json& json, std::int32_t& v) { read_integer(json, v); }
  void read(const Json& json, std::string& v);
  void read(const Json& json, Vec2& v) { read_tuple(json, v.x, v.y); }
  void read(const Json& json, Vec3& v) { read_tuple(json, v.x, v.y, v.z); }
  void read(const Json& json, Color& c) { read_tuple(json, c.r, c.g, c.b); }
  void read(const Json& json, PigmentColor& c) {
    read_tuple(json, c.color.r, c.color.g, c.color.b, c.filter, c.transmit);
  }
  template <class T>
  void read(const Json& json, Id<T>& id) {
    if (json.is_null()) {
      id = {};
    } else {
      read_integer(json, id.index);
    }
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void read(const Json& json, Enum& v) {
    if (!json.is_string()) return fail("expected a name");
    const auto value = enum_value<Enum>(json.get_ref<const std::string&>());
    if (!value) return fail("unknown name");
    v = *value;
  }
  template <class T>
  void read(const Json& json, Shared<T>& v) {
    T value;
    read(json, value);
    v = Shared<T>(std::move(value));
  }
  template <class T>
  void read(const Json& json, std::vector<T>& v) {
    if (!json.is_array()) return fail("expected an array");
    v.clear();
    v.resize(json.size());
    for (std::size_t k = 0; k < v.size() && good(); ++k) {
      within(std::to_string(k), [&] { read(json[k], v[k]); });
    }
  }
  template <class T, std::size_t N>
  void read(const Json& json, std::array<T, N>& v) {
    if (!json.is_array() || json.size() != N) {
      return fail("expected an array of " + std::to_string(N));
    }
    for (std::size_t k = 0; k < N && good(); ++k) {
      within(std::to_string(k), [&] { read(json[k], v[k]); });
    }
  }
  template <class... T>
  void read(const Json& json, std::variant<T...>& v) {
    const std::string* type = type_of(json);
    if (type == nullptr) return fail("expected an object with a \"type\"");
    if (!read_alternative(json, *type, v)) within("type", [&] { fail("unknown type"); });
  }
  template <HasFields T>
  void read(const Json& json, T& v) {
    if (!json.is_object()) return fail("expected an object");
    std::size_t known = Named<T> && json.contains("type") ? 1 : 0;
    T::fields(v, [&](const char* name, auto& field) {
      const auto found = json.find(name);
      if (found == json.end() || !good()) return;
      ++known;
      within(name, [&] { read(*found, field); });
    });
    if (good() && known != json.size()) fail_unknown_field<T>(json, v);
  }

 private:
  /// Adds the place to a problem that `body` meets.
  template <class Body>
  void within(const std::string& part, Body&& body) {
    path_.push_back(part);
    body();
    path_.pop_back();
  }
  void fail(const std::string& what);
  static const std::string* type_of(const Json& json);

  template <class Integer>
  void read_integer(const Json& json, Integer& v) {
    if (!json.is_number_integer()) return fail("expected a whole number");
    const bool fits = json.is_number_unsigned()
                          ? json.get<std::uint64_t>() <=
                                static_cast<std::uint64_t>(std::numeric_limits<Integer>::max())
                          : json.get<std::int64_t>() >=
                                static_cast<std::int64_t>(std::numeric_limits<Integer>::min());
    if (!fits) return fail("the number is out of range");
    v = json.get<Integer>();
  }
  template <class... Numbers>
  void read_tuple(const Json& json, Numbers&... v) {
    if (!json.is_array() || json.size() != sizeof...(Numbers)) {
      return fail("expected " + std::to_string(sizeof...(Numbers)) + " numbers");
    }
    std::size_t k = 0;
    (within(std::to_string(k), [&] { read(json[k++], v); }), ...);
  }

  /// Reads the alternative called `type`, also inside alternatives that are variants themselves.
  template <class... T>
  bool read_alternative(const Json& json, const std::string& type, std::variant<T...>& v) {
    return (try_alternative<T>(json, type, v) || ...);
  }
  template <class T, class Variant>
  bool try_alternative(const Json& json, const std::string& type, Variant& v) {
    T value;
    if constexpr (Named<T>) {
      if (type != T::kName) return false;
      read(json, value);
    } else {
      if (!read_alternative(json, type, value)) return false;
    }
    v = std::move(value);
    return true;
  }

  template <class T>
  void fail_unknown_field(const Json& json, T& v) {
    for (const auto& [key, value] : json.items()) {
      bool known = Named<T> && key == "type";
      T::fields(v, [&](const char* name, auto&) { known = known || key == name; });
      if (!known) within(key, [&] { fail("unknown field"); });
    }
  }

  std::vector<std::string> path_;
  std::string problem_;
};

}  // namespace dioptre::json
