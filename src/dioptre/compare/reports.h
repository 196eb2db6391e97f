// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dioptre/compare/comparison.h"

namespace dioptre {

/// For a terminal of 80 columns: tables, and below what they say in words.
std::string table_report(const Comparison& comparison);

/// A header and a line for each structure. Times are in seconds but for those of single rays, in
/// nanoseconds; a field is empty where there is nothing to say.
std::string csv_report(const Comparison& comparison);

/// All of the comparison but the picture.
std::string json_report(const Comparison& comparison);

/// One self-contained page with charts and the picture, whose bytes as a PNG file are `png`.
std::string html_report(const Comparison& comparison, std::string_view png);

/// Sentences: whether all is equal, which structure is the fastest for each sort of rays, and what
/// it does less of than the others.
std::vector<std::string> in_words(const Comparison& comparison);

}  // namespace dioptre
