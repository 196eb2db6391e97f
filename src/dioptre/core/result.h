// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace dioptre {

/// Why something could not be done, for a person to read. Where it has a place in a file, the
/// reader that knows the place reports it through Diagnostics.
struct Error {
  std::string message;
};

/// A value or the reason why there is none.
template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string message) {
  return tl::unexpected<Error>(Error{std::move(message)});
}

}  // namespace dioptre
