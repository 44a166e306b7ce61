// SPDX-License-Identifier: MIT
#include <fuzz/support/mutate_json.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace lightcuts::fuzz {
namespace {

using Json = nlohmann::ordered_json;

void collect(Json& json, std::vector<Json*>& all) {
  all.push_back(&json);
  if (json.is_structured())
    for (Json& child : json) collect(child, all);
}

std::vector<Json*> nodes_of(Json& json) {
  std::vector<Json*> all;
  collect(json, all);
  return all;
}

template <class List>
auto& any_of(gen::Dice& dice, List& list) {
  return list[std::size_t(dice.bits() % list.size())];
}

Json number(gen::Dice& dice) {
  switch (dice.below(5)) {
  case 0:
    return dice.between(-2, 8);
  case 1:
    return dice.pick<std::int64_t>({127, 128, 255, 256, 5120, 5121, 5123, 5125, 5126, 16384, 16385,
                                    65535, 65536, 2147483647, 2147483648, 4294967295, 4294967296});
  case 2:
    return dice.pick<std::uint64_t>({UINT64_MAX, UINT64_MAX / 2, UINT64_MAX / 2 + 1,
                                     UINT64_MAX / 4 + 1, std::uint64_t{1} << 53});
  case 3:
    return dice.pick({1e308, -1e308, 5e-324, 3.5e38, 3.4028235e38, 1e-46, -0.0, 0.5, 180.0, 1e19});
  default:
    return double(dice.finite_float());
  }
}

Json scalar(gen::Dice& dice) {
  switch (dice.below(8)) {
  case 0:
    return nullptr;
  case 1:
    return dice.one_in(2);
  case 2:
    return dice.pick<const char*>({"", "0x1p-149", "0x1.fffffep+127", "-0x1p+0", "nan", "a\nb", ".",
                                   "four.png", "square.obj", "\xf0\x9f\x92\xa1"});
  case 3:
    return Json::array();
  case 4:
    return Json::object();
  default:
    return number(dice);
  }
}

/// Some key of some object; "" where that one has none.
std::string any_key(gen::Dice& dice, const std::vector<Json*>& all) {
  const Json& object = *any_of(dice, all);
  if (!object.is_object() || object.empty()) return {};
  auto member = object.begin();
  std::advance(member, std::ptrdiff_t(dice.bits() % object.size()));
  return member.key();
}

/// One of its children goes, comes again, or takes another's key.
void rearrange(gen::Dice& dice, Json& parent, const std::vector<Json*>& all) {
  if (parent.empty()) return;
  const std::size_t at = std::size_t(dice.bits() % parent.size());
  const int what = dice.below(3);
  if (parent.is_array()) {
    if (what == 0) return parent.erase(at);
    const Json copy = parent[at];
    const int times = what == 1 ? 1 : dice.between(2, 20);
    for (int i = 0; i < times; ++i) parent.push_back(copy);
  } else if (parent.is_object()) {
    const std::string key = any_key(dice, all); // before any of them goes
    auto child = parent.begin();
    std::advance(child, std::ptrdiff_t(at));
    const Json value = child.value();
    if (what != 1) parent.erase(std::string(child.key()));
    if (what != 0) parent[key] = value;
  }
}

void change_once(gen::Dice& dice, Json& root, const Bytewise& bytewise) {
  const std::vector<Json*> all = nodes_of(root);
  Json& node = *any_of(dice, all);
  switch (dice.below(6)) {
  case 0:
    node = scalar(dice);
    return;
  case 1:
    if (const Json copy = *any_of(dice, all); true) node = copy;
    return;
  case 2:
    return rearrange(dice, node, all);
  case 3:
    if (Json& other = *any_of(dice, all); !node.is_structured() && !other.is_structured())
      std::swap(node, other);
    return;
  default:
    break;
  }
  if (node.is_number_float())
    node = node.get<double>() *
           (dice.one_in(2) ? dice.uniform(-2, 2) : std::pow(10, dice.uniform(-40, 40)));
  else if (node.is_number())
    node = dice.one_in(2) ? number(dice)
                          : Json(node.get<std::uint64_t>() + std::uint64_t(dice.between(-2, 2)));
  else if (node.is_string())
    node = bytewise(node.get<std::string>());
  else if (node.is_boolean())
    node = !node.get<bool>();
  else
    rearrange(dice, node, all);
}

} // namespace

std::string mutated_json(const std::string& input, gen::Dice& dice, const Bytewise& bytewise) {
  Json json = Json::parse(input, nullptr, false);
  if (json.is_discarded()) return bytewise(input);
  for (int i = dice.between(1, 4); i > 0; --i) change_once(dice, json, bytewise);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace lightcuts::fuzz
