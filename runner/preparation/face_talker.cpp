#include "runner/preparation/face_talker.hpp"

#include <utility>

#include "synth/speech/articulation.hpp"

namespace bimodal::runner {

namespace {

class TalkingFace final : public FrameSource {
 public:
  TalkingFace(synth::HeadRenderer& renderer, synth::Articulation articulation, Bearing bearing)
      : renderer_{renderer}, articulation_{std::move(articulation)}, bearing_{std::move(bearing)} {}

  [[nodiscard]] std::int64_t picture_at(Duration time) override { return time.count(); }

  [[nodiscard]] std::shared_ptr<const Image> paint(Duration time) override {
    auto image = std::make_shared<Image>();
    renderer_.draw(bearing_.of(articulation_.at(time)), *image);
    return image;
  }

 private:
  synth::HeadRenderer& renderer_;
  synth::Articulation articulation_;
  Bearing bearing_;
};

}  // namespace

FaceTalker::FaceTalker(const synth::Head& head, const ShownLook& look, synth::Quality quality)
    : renderer_{head,
                view_of(look.face, look.lines, look.background),
                appearance_of(look.face, quality)} {}

std::unique_ptr<FrameSource> FaceTalker::say(std::span<const TimedSegment> segments,
                                             const synth::SegmentTable& table,
                                             Account account,
                                             Bearing bearing) {
  return std::make_unique<TalkingFace>(
      renderer_, synth::Articulation{segments, table, account}, std::move(bearing));
}

}  // namespace bimodal::runner
