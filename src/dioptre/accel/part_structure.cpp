// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/part_structure.h"

#include <utility>

namespace dioptre {

PartStructure::PartStructure(std::string_view name, std::span<const Bounds> boxes,
                             std::uint32_t leaf_size) {
  if (name != accelerator_names().front()) {
    if (auto made = make_accelerator(name, boxes)) other_ = std::move(*made);
  }
  if (!other_) tree_ = BoundingVolumeHierarchy(boxes, leaf_size);
}

}  // namespace dioptre
