#include "runner/store/schema_check.hpp"

#include <fmt/format.h>

#include "runner/store/schema.hpp"
#include "runner/store/store_error.hpp"

namespace bimodal::runner {

namespace {

bool is_empty(Database& database) {
  Statement statement{database, "SELECT count(*) FROM sqlite_schema"};
  return statement.step() && statement.integer(0) == 0;
}

}  // namespace

void check_schema(Database& database, const std::string& file) {
  if (database.pragma("application_id") != kApplicationId) {
    throw StoreError{
        fmt::format("'{}' is not a bimodal data file; name a file that `bimodal run` or `bimodal "
                    "rehearse` made",
                    file)};
  }
  const auto version = database.pragma("user_version");
  if (version > kSchemaVersion) {
    throw StoreError{fmt::format(
        "'{}' has data of schema version {}, and this program knows versions up to {}; update "
        "bimodal, or name another file",
        file,
        version,
        kSchemaVersion)};
  }
}

void prepare_schema(Database& database, const std::string& file) {
  // First judged, for the journal mode is written into the file, which may be somebody else's.
  const bool is_new = is_empty(database);
  if (!is_new) check_schema(database, file);
  database.execute("PRAGMA journal_mode = WAL");
  database.execute("PRAGMA synchronous = FULL");
  database.execute("PRAGMA foreign_keys = ON");
  if (!is_new && database.pragma("user_version") == kSchemaVersion) return;
  Transaction transaction{database};
  // Asked again, for somebody may have been quicker.
  const auto version = is_empty(database) ? 0 : database.pragma("user_version");
  for (auto step = static_cast<std::size_t>(version); step < kSchemaSteps.size(); ++step) {
    database.execute(kSchemaSteps.at(step));
  }
  database.execute(fmt::format("PRAGMA application_id = {}", kApplicationId).c_str());
  database.execute(fmt::format("PRAGMA user_version = {}", kSchemaVersion).c_str());
  transaction.commit();
}

}  // namespace bimodal::runner
