#pragma once

#include <string>
#include <string_view>

namespace bimodal {

/// A field of a CSV table, put in quotation marks where it must be (RFC 4180).
[[nodiscard]] std::string csv_field(std::string_view text);

}  // namespace bimodal
