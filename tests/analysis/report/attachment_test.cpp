#include "analysis/report/attachment.hpp"

#include "stimuli/base/error.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

TEST(ReadAttachment, TakesTheCaptionBehindTheFile) {
  const WrittenFiles folder;
  const auto file = folder.write("a:b.png", "\x89PNG\r\n and more");
  const auto attachment =
      read_attachment(Attachment::Kind::Picture, file.string() + ":Trial 3: mid-word");
  EXPECT_EQ(attachment.media_type, "image/png");
  EXPECT_EQ(attachment.caption, "Trial 3: mid-word");
  EXPECT_EQ(read_attachment(Attachment::Kind::Picture, file.string()).caption, "a:b.png");
}

TEST(ReadAttachment, RefusesWhatIsMissingOrOfAnotherKind) {
  const WrittenFiles folder;
  const auto picture = folder.write("a.png", "\x89PNG\r\n and more").string();
  EXPECT_THROW(static_cast<void>(read_attachment(Attachment::Kind::Sound, picture)), Error);
  EXPECT_THROW(static_cast<void>(read_attachment(Attachment::Kind::Picture, "none.png:caption")),
               Error);
}

}  // namespace
}  // namespace bimodal::analysis
