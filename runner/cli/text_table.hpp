#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bimodal::runner {

/// Prints rows, the first with the headings, in columns as wide as their longest text, two spaces
/// apart. `sides` has a letter for each column: 'l' puts its texts to the left, 'r' to the right.
/// Precondition: every row has as many texts as there are letters.
void print_text_table(const std::vector<std::vector<std::string>>& rows, std::string_view sides);

}  // namespace bimodal::runner
