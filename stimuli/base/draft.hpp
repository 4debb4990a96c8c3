#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bimodal {

/// Whether a kept file survives a power cut at once, for which its writer (and everyone else who
/// waits for that disk) waits, or some seconds later: for files that can be made again and that
/// show whether they are whole.
enum class Durability { AtOnce, Later };

/// A file that is written under another name beside its target, so that the target is never half
/// there: `keep` gives it its name, and what is not kept is removed.
class Draft {
 public:
  /// Creates nothing yet.
  explicit Draft(const std::filesystem::path& target);

  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  Draft(Draft&&) = delete;
  Draft& operator=(Draft&&) = delete;
  ~Draft();

  /// Where to write.
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Gives the draft its final name, replacing what had it; if it is to be durable at once, when
  /// its content is on the disk. Throws Error, naming the target, if that fails.
  void keep(Durability durability = Durability::AtOnce);

 private:
  std::string path_;
  std::filesystem::path target_;
  bool kept_ = false;
};

/// Writes a whole file by way of a draft. Throws Error, naming the file, if it cannot be written.
void write_file(const std::filesystem::path& file,
                std::string_view content,
                Durability durability = Durability::AtOnce);

}  // namespace bimodal
