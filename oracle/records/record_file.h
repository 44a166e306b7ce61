// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <lightcuts/render/io/json/json_text.h>
#include <oracle/records/record_json.h>

/// A record as the whole of a JSON file, whose member "schema" says which kind and version it is.
namespace lightcuts::oracle {

template <Record R>
[[nodiscard]] std::string record_file(const char* schema, const R& record, Floats floats) {
  Json json{{"schema", schema}};
  append_fields(json, record, floats);
  return indented(json) + "\n";
}

/// Reads what record_file() writes, then calls check(root) for whatever is demanded beyond the
/// fields' domains. Throws InputError that names `file` and the member: also for members that are
/// unknown, and for any other schema.
template <Record R, class Check>
void read_record_file(const std::string& file, const std::string& text, const std::string& schema,
                      R& record, Check&& check) {
  const nlohmann::json json = parse_json(file, text);
  const JsonElement root(file, json);
  // First: members of another version are unknown to this one.
  if (root.has("schema"))
    if (const std::string own = root["schema"].string(); own != schema)
      root["schema"].refuse(InputFault::unsupported,
                            fmt::format("is \"{}\", expected \"{}\"", own, schema));
  std::vector<std::string> keys{"schema"};
  append_keys<R>(keys);
  root.expect_keys(keys);
  (void)root["schema"];
  read_fields(root, record);
  check(root);
}

} // namespace lightcuts::oracle
