#include "runner/devices/local/line_splitter.hpp"

#include "stimuli/base/utf8.hpp"

namespace bimodal::runner {

void LineSplitter::feed(std::string_view bytes, const Take& take) {
  while (!bytes.empty()) {
    const auto end = bytes.find('\n');
    const auto part = bytes.substr(0, end);
    const auto room = longest_ - line_.size();
    overlong_ = overlong_ || part.size() > room;
    line_ += part.substr(0, room);
    if (end == std::string_view::npos) return;
    finish(take);
    bytes.remove_prefix(end + 1);
  }
}

void LineSplitter::finish(const Take& take) {
  std::string_view line{line_};
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (overlong_) {
    take(Verdict::Overlong, line);
  } else if (!line.empty()) {
    take(is_utf8(line) ? Verdict::Fine : Verdict::NotText, line);
  }
  line_.clear();
  overlong_ = false;
}

}  // namespace bimodal::runner
