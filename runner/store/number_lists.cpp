#include "runner/store/number_lists.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runner/store/store_error.hpp"

namespace bimodal::runner {

std::string as_json(std::span<const std::int64_t> numbers) {
  return fmt::format("[{}]", fmt::join(numbers.begin(), numbers.end(), ","));
}

std::string as_json(std::span<const Duration> instants, Duration origin) {
  std::vector<std::int64_t> since(instants.size());
  std::ranges::transform(
      instants, since.begin(), [&](Duration at) { return (at - origin).count(); });
  return as_json(since);
}

std::vector<std::int64_t> numbers_from(const std::string& json) {
  const auto parsed = nlohmann::json::parse(json, nullptr, false);
  const bool is_list = parsed.is_array() && std::ranges::all_of(parsed, [](const auto& number) {
                         return number.is_number_integer();
                       });
  if (!is_list) throw StoreError{"a list of refreshes in the data file is damaged"};
  return parsed.get<std::vector<std::int64_t>>();
}

std::vector<Duration> instants_from(const std::string& json, Duration origin) {
  std::vector<Duration> instants;
  for (const auto since : numbers_from(json)) instants.push_back(origin + Duration{since});
  return instants;
}

}  // namespace bimodal::runner
