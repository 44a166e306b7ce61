// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <type_traits>

#include <viz/model/layers/kinds/block_size.h>
#include <viz/model/layers/kinds/certified_error.h>
#include <viz/model/layers/kinds/clairvoyant.h>
#include <viz/model/layers/kinds/cut_size.h>
#include <viz/model/layers/kinds/error.h>
#include <viz/model/layers/kinds/image.h>
#include <viz/model/layers/kinds/proven.h>
#include <viz/model/layers/kinds/shadow_rays.h>
#include <viz/model/layers/kinds/slack.h>
#include <viz/model/layers/kinds/time.h>
#include <viz/model/layers/kinds/violations.h>

namespace lightcuts::viz {

/// In the order of menus and keys.
inline constexpr Layer all_layers[] = {
    layers::image,           layers::cut_size,    layers::shadow_rays, layers::error,
    layers::certified_error, layers::slack,       layers::time,        layers::block_size,
    layers::proven,          layers::clairvoyant, layers::violations};

[[nodiscard]] constexpr auto values_of(std::type_identity<Layer> /*type*/) {
  return std::to_array(all_layers);
}
/// The next one in that order, or with -1 the one before; it goes round.
[[nodiscard]] Layer next(Layer layer, int direction);

} // namespace lightcuts::viz
