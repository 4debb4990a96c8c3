#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace bimodal::runner {

/// Cuts a stream of bytes into lines ('\n' ends one; a '\r' before it is left out), keeping at most
/// one unfinished line of `longest` bytes. For one thread.
class LineSplitter {
 public:
  enum class Verdict {
    Fine,
    Overlong,  ///< longer than `longest`; its beginning is given, the rest is left out
    NotText    ///< not UTF-8
  };

  using Take = std::function<void(Verdict, std::string_view line)>;

  explicit LineSplitter(std::size_t longest) : longest_{longest} {}

  /// Calls `take` for every line that ends within `bytes`. Empty lines are passed over.
  void feed(std::string_view bytes, const Take& take);

 private:
  void finish(const Take& take);

  std::size_t longest_;
  std::string line_;
  bool overlong_ = false;
};

}  // namespace bimodal::runner
