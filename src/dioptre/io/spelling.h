// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace dioptre {

/// The number of letters to insert, delete and replace to make one word the other (Levenshtein
/// 1966); upper and lower case ASCII letters count as the same.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Whether somebody who wrote `written` may have meant `known`: about one letter in three is wrong,
/// and words of under four letters are never alike.
bool is_misspelling(std::string_view written, std::string_view known);

}  // namespace dioptre
