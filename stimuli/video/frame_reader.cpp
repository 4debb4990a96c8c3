#include "stimuli/video/frame_reader.hpp"

#include <algorithm>
#include <deque>
#include <exception>
#include <utility>

#include "stimuli/base/error.hpp"
#include "stimuli/video/deinterlacer.hpp"
#include "stimuli/video/frame_sequence.hpp"
#include "stimuli/video/picture_converter.hpp"
#include "stimuli/video/survey.hpp"

namespace bimodal {

namespace {

/// Frames so shortly before the stretch are deinterlaced too: the filter looks back.
constexpr Duration kRunUp = std::chrono::milliseconds{200};

libav::Survey seen(const std::filesystem::path& file, Duration until) {
  auto survey = libav::survey_of(file, until);
  if (!survey.media.picture) {
    libav::refuse("show", file, "it has no picture that can be decoded", "name a video");
  }
  return survey;
}

}  // namespace

struct FrameReader::Decoder {
  Decoder(const std::filesystem::path& file, const FrameOptions& options);

  std::optional<libav::Decoded> decode();
  std::optional<libav::Decoded> whole();

  std::filesystem::path file;
  libav::Survey survey;
  Duration start;
  Duration end;
  libav::PictureConverter converter;
  libav::FrameSequence sequence;
  std::optional<libav::Deinterlacer> deinterlacer;
  std::deque<libav::Decoded> in_filter;
  bool drained = false;
  std::optional<libav::Decoded> held;  ///< the next to be handed out
  std::optional<libav::Decoded> following;
  std::exception_ptr failure;  ///< met after the frames that are still to be handed out
};

FrameReader::Decoder::Decoder(const std::filesystem::path& given, const FrameOptions& options)
    : file{given},
      survey{seen(file, options.span.end)},
      start{options.span.start},
      end{libav::end_within(survey, file, options.span.start, options.span.end)},
      converter{file, survey, options.height},
      sequence{file, survey, options.span.start} {
  // The last frame that begins no later than the stretch is the one seen at its start.
  held = whole();
  following = whole();
  while (following && following->start <= start) {
    held = std::exchange(following, whole());
  }
  const bool seen_at_start = held && (following || held->start + held->length > start);
  if (seen_at_start) return;
  if (failure) std::rethrow_exception(failure);
  libav::refuse("show",
                file,
                "its picture ends before " + libav::in_seconds(start),
                "choose a stretch in which there is something to be seen");
}

/// A failure counts as the end until all frames before it have been handed out.
std::optional<libav::Decoded> FrameReader::Decoder::decode() {
  if (failure) return std::nullopt;
  try {
    return sequence.next();
  } catch (const Error&) {
    failure = std::current_exception();
    return std::nullopt;
  }
}

/// The next frame, deinterlaced if need be.
std::optional<libav::Decoded> FrameReader::Decoder::whole() {
  while (true) {
    if (deinterlacer) {
      auto frame = libav::new_frame();
      if (deinterlacer->pull(*frame) && !in_filter.empty()) {
        auto made = std::move(in_filter.front());
        in_filter.pop_front();
        made.frame = std::move(frame);
        return made;
      }
    }
    if (drained) return std::nullopt;
    auto decoded = decode();
    if (decoded && !deinterlacer && decoded->frame->interlaced_frame != 0 &&
        decoded->start + kRunUp >= start) {
      deinterlacer.emplace(file, *decoded->frame, sequence.unit());
    }
    if (!deinterlacer) return decoded;
    drained = !decoded;
    deinterlacer->push(decoded ? decoded->frame.get() : nullptr);
    if (decoded) in_filter.push_back(std::move(*decoded));
  }
}

FrameReader::FrameReader(const std::filesystem::path& file, const FrameOptions& options)
    : decoder_{std::make_unique<Decoder>(file, options)} {}

FrameReader::~FrameReader() = default;
FrameReader::FrameReader(FrameReader&&) noexcept = default;
FrameReader& FrameReader::operator=(FrameReader&&) noexcept = default;

std::optional<VideoFrame> FrameReader::next(Image reuse) {
  auto& decoder = *decoder_;
  if (!decoder.held) {
    if (decoder.failure) std::rethrow_exception(decoder.failure);
    return std::nullopt;
  }
  const auto& now = *decoder.held;
  if (now.start >= decoder.end) return std::nullopt;
  VideoFrame frame{.index = now.index,
                   .start = now.start,
                   .end = decoder.following ? decoder.following->start : now.start + now.length,
                   .image = decoder.converter.convert(*now.frame, std::move(reuse))};
  decoder.held = std::exchange(decoder.following, std::nullopt);
  if (decoder.held && decoder.held->start < decoder.end) {
    decoder.following = decoder.whole();
  } else if (frame.end >= decoder.end) {
    decoder.failure = nullptr;
  }
  return frame;
}

std::size_t FrameReader::width() const {
  return decoder_->converter.width();
}

std::size_t FrameReader::height() const {
  return decoder_->converter.height();
}

}  // namespace bimodal
