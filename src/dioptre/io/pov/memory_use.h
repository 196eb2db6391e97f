// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace dioptre::pov {

/// The bytes of memory that this process holds now; 0 if the system does not tell.
std::uint64_t resident_bytes();

}  // namespace dioptre::pov
