// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

namespace dioptre {

/// How descriptions name their parameters. A plain struct T says
///
///   template <class Self, class Visitor>
///   static void fields(Self& self, Visitor&& visit) { visit("radius", self.radius); ... }
///
/// once, and JSON, dump, validation and documentation all come from that. A struct that is a
/// member of a variant also says `static constexpr const char* kName`, its name in that variant.
struct AnyVisitor {
  template <class F>
  void operator()(const char*, F&) const {}
};

template <class T>
concept HasFields = requires(T& t, AnyVisitor v) {
  T::fields(t, v);
};

template <class T>
concept Named = requires {
  T::kName;
};

}  // namespace dioptre
