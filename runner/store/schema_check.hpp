#pragma once

#include <string>

#include "runner/store/sqlite.hpp"

namespace bimodal::runner {

/// Makes the tables in an empty file, and raises those of an older version to this one, in one
/// transaction that changes nothing that is stored; refuses, with StoreError, a file that another
/// kind of program made or that a newer version of this one made.
void prepare_schema(Database& database, const std::string& file);

/// The same judgement without changing anything; an empty file is refused.
void check_schema(Database& database, const std::string& file);

}  // namespace bimodal::runner
