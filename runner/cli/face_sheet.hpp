#pragma once

#include <string>
#include <vector>

#include "stimuli/picture/image.hpp"

namespace bimodal::runner {

/// One picture of a contact sheet and what stands below it.
struct SheetCell {
  Image picture;
  std::string caption;
};

/// A line of pictures, all sheets' of one size, with its title above.
struct SheetRow {
  std::string title;  ///< empty: no line is left for it
  std::vector<SheetCell> cells;
};

/// Rows of pictures with captions on white. Precondition: there is a picture, and all are of one
/// size.
[[nodiscard]] Image contact_sheet(const std::vector<SheetRow>& rows);

}  // namespace bimodal::runner
