// SPDX-License-Identifier: MIT
// The file of `check --resume`: what is read is saved as it was.
#include <nlohmann/json.hpp>

#include <oracle/cli/campaign_file.h>

#include <fuzz/support/files.h>
#include <fuzz/support/mutate_json.h>

namespace lightcuts::fuzz {
namespace {

void run_campaign(Bytes input) {
  static const WorkFolder folder;
  const auto file = folder.put("fuzzed.campaign", text_of(input));
  read_or_refused("fuzzed.campaign", [&] {
    const nlohmann::ordered_json what{{"scene", "desk"}, {"seed", 1}};
    const oracle::CheckResult result = cli::CampaignFile(file, what).load();
    const cli::CampaignFile copy(folder.path("copy.campaign"), what);
    copy.save(result);
    if (!(copy.load().tally == result.tally)) finding("is read as another one than was written");
  });
}

const Registered campaign({"campaign", run_campaign, mutated_json});

} // namespace
} // namespace lightcuts::fuzz
