// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace dioptre {

/// Where a value falls in a map: between two neighbouring entries, by the share of the second.
/// With a share of 0 only the first counts.
struct MapPlace {
  std::uint32_t first = 0, second = 0;
  float share = 0;
};

/// The places of the entries of a map (of colours, pigments, ...), made ready for looking up.
/// Entries stand in the order of the scene: a value belongs between the first entry that reaches it
/// and the entry before that one; outside it takes the first or the last entry.
class PositionMap {
 public:
  /// `list`: the value is the number of an entry. Otherwise positions of the entries.
  template <class Entry>
  PositionMap(const std::vector<Entry>& entries, bool list)
      : count_(static_cast<std::uint32_t>(entries.size())) {
    if (list) return;
    positions_.reserve(entries.size());
    for (const Entry& entry : entries) positions_.push_back(entry.position);
    find_reach();
  }

  bool empty() const { return count_ == 0; }

  /// The place of a value; anything if the map is empty. Not a number counts as the smallest.
  MapPlace find(double value) const;

 private:
  void find_reach();

  std::uint32_t count_;
  std::vector<double> positions_;  ///< none for a list
  std::vector<double> reach_;      ///< the largest position up to each entry
};

/// The weights of the entries of an average, which sum to 1.
template <class Entry>
std::vector<float> average_weights(const std::vector<Entry>& entries) {
  double sum = 0;
  for (const Entry& entry : entries) sum += entry.position;
  std::vector<float> weights;
  weights.reserve(entries.size());
  for (const Entry& entry : entries) {
    weights.push_back(static_cast<float>(sum != 0 ? entry.position / sum : 0));
  }
  return weights;
}

}  // namespace dioptre
