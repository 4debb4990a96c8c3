#include "runner/devices/local/line_server.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <exception>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/local/line_ring.hpp"
#include "runner/devices/local/line_splitter.hpp"
#include "runner/devices/local/local_socket.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kEverybody = 0;
constexpr auto kFarewell = 200ms;

/// Lines of clients that nobody has taken yet, in bytes.
constexpr std::size_t kInbox = 64UL << 10U;

/// What is read from one client before the others have their turn.
constexpr std::size_t kTurn = 16UL << 10U;

/// Where the system has no more descriptors, new clients are looked for this often.
constexpr int kRestMs = 1'000;

std::string complaint(std::string_view text) {
  return fmt::format(R"({{"kind":"error","text":"{}"}})", text);
}

/// Somebody connected, as the server's thread sees it.
class Client {
 public:
  Client(Descriptor socket, std::uint32_t number, const LineServerOptions& options)
      : socket_{std::move(socket)},
        number_{number},
        most_unread_{options.most_unread},
        splitter_{options.longest_line} {}

  [[nodiscard]] int socket() const { return socket_.number(); }

  [[nodiscard]] std::uint32_t number() const { return number_; }

  [[nodiscard]] bool has_left() const { return left_; }

  [[nodiscard]] bool has_unsent() const { return !left_ && !unsent_.empty(); }

  /// A client that has let too much lie unread leaves.
  void tell(std::string_view line) {
    if (left_) return;
    if (unsent_.size() + line.size() + 1 > most_unread_) send();
    left_ = left_ || unsent_.size() + line.size() + 1 > most_unread_;
    if (left_) return;
    unsent_ += line;
    unsent_ += '\n';
  }

  /// As much as the system takes now.
  void send() {
    while (has_unsent()) {
      const auto sent =
          ::send(socket_.number(), unsent_.data(), unsent_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent < 0 && errno == EINTR) continue;
      if (sent < 0) {
        left_ = errno != EAGAIN && errno != EWOULDBLOCK;
        return;
      }
      unsent_.erase(0, static_cast<std::size_t>(sent));
    }
  }

  /// One turn.
  void receive(const LineSplitter::Take& take) {
    std::array<char, kTurn> bytes{};
    const auto count = ::recv(socket_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (count > 0) splitter_.feed({bytes.data(), static_cast<std::size_t>(count)}, take);
    const bool passing = count < 0 && (errno == EAGAIN || errno == EINTR);
    left_ = left_ || (count <= 0 && !passing);
  }

 private:
  Descriptor socket_;
  std::uint32_t number_;
  std::size_t most_unread_;
  LineSplitter splitter_;
  std::string unsent_;
  bool left_ = false;
};

}  // namespace

/// The server's thread and what it owns; the rings and the atomic values are what it shares.
class LineServer::Work {
 public:
  Work(const std::filesystem::path& socket, const LineServerOptions& options)
      : options_{options},
        listening_{socket},
        wake_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)},
        outbox_{options.hand_over},
        inbox_{kInbox} {
    if (!wake_.is_open()) {
      throw DeviceError{"the system gave no event descriptor; close other programs"};
    }
    thread_ = std::thread{[this] { run(); }};
  }

  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  Work(Work&&) = delete;
  Work& operator=(Work&&) = delete;

  ~Work() {
    closing_ = true;
    wake();
    thread_.join();
  }

  bool hand_over(std::uint32_t client, std::string_view kind, std::string_view line) noexcept {
    if (line.find('\n') != std::string_view::npos) return false;
    if (!outbox_.try_push(client, kind, line)) return false;
    wake();
    return true;
  }

  std::optional<ReceivedLine> next_line() {
    auto line = inbox_.try_pop();
    if (!line) return std::nullopt;
    return ReceivedLine{.client = line->address, .text = std::move(line->text)};
  }

  [[nodiscard]] std::size_t clients() const noexcept { return count_.load(); }

 private:
  void wake() noexcept {
    const std::uint64_t one = 1;
    static_cast<void>(::write(wake_.number(), &one, sizeof one) == sizeof one);
  }

  /// Whatever happens here, the session goes on.
  void run() noexcept {
    try {
      while (!closing_) {
        await_something();
        serve();
      }
      part();
    } catch (const std::exception&) {  // out of memory: nobody is told anything any more
    }
    clients_.clear();
    count_ = 0;
  }

  void await_something() {
    polled_.clear();
    polled_.push_back({.fd = wake_.number(), .events = POLLIN, .revents = 0});
    polled_.push_back({.fd = resting_ ? -1 : listening_.number(), .events = POLLIN, .revents = 0});
    for (const auto& client : clients_) {
      const int events = POLLIN | (client.has_unsent() ? POLLOUT : 0);
      polled_.push_back(
          {.fd = client.socket(), .events = static_cast<short>(events), .revents = 0});
    }
    ::poll(polled_.data(), polled_.size(), resting_ ? kRestMs : -1);
  }

  /// Polled descriptors 0 and 1 are ours; the others are those of clients_, in order.
  void serve() {
    std::uint64_t ignored = 0;
    static_cast<void>(::read(wake_.number(), &ignored, sizeof ignored) > 0);
    for (std::size_t i = 0; i + 2 < polled_.size(); ++i) {
      if ((polled_[i + 2].revents & (POLLIN | POLLHUP | POLLERR)) != 0) hear(clients_[i]);
    }
    distribute();  // before anybody is welcomed, who is told the newest lines
    if (resting_ || (polled_[1].revents & POLLIN) != 0) welcome();
    for (auto& client : clients_) client.send();
    std::erase_if(clients_, [](const Client& client) { return client.has_left(); });
    count_ = clients_.size();
  }

  void hear(Client& client) {
    client.receive([&](LineSplitter::Verdict verdict, std::string_view line) {
      if (verdict == LineSplitter::Verdict::Overlong) {
        client.tell(complaint(fmt::format("a line has at most {} bytes", options_.longest_line)));
      } else if (verdict == LineSplitter::Verdict::NotText) {
        client.tell(complaint("a line must be UTF-8"));
      } else if (!inbox_.try_push(client.number(), "", line)) {
        client.tell(complaint("too many lines at once; wait for the session to take them"));
      }
    });
  }

  void welcome() {
    auto [socket, exhausted] = listening_.accept();
    resting_ = exhausted;
    if (!socket.is_open()) return;
    if (clients_.size() == options_.most_clients) {
      const auto refusal = complaint("too many programs are connected; end one") + "\n";
      ::send(socket.number(), refusal.data(), refusal.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      return;
    }
    clients_.emplace_back(std::move(socket), ++last_number_, options_);
    for (const auto& [kind, line] : newest_) clients_.back().tell(line);
    if (!options_.welcome.empty()) clients_.back().tell(options_.welcome);
  }

  void distribute() {
    while (auto line = outbox_.try_pop()) {
      for (auto& client : clients_) {
        if (line->address == kEverybody || line->address == client.number()) {
          client.tell(line->text);
        }
      }
      if (!line->kind.empty()) keep(std::move(line->kind), std::move(line->text));
    }
  }

  void keep(std::string kind, std::string line) {
    const auto known =
        std::ranges::find(newest_, kind, [](const auto& kept) { return kept.first; });
    if (known == newest_.end()) {
      newest_.emplace_back(std::move(kind), std::move(line));
    } else {
      known->second = std::move(line);
    }
  }

  /// What has been published still goes to those who read.
  void part() {
    distribute();
    const auto end = std::chrono::steady_clock::now() + kFarewell;
    while (std::chrono::steady_clock::now() < end) {
      polled_.clear();
      for (auto& client : clients_) {
        client.send();
        if (client.has_unsent()) {
          polled_.push_back({.fd = client.socket(), .events = POLLOUT, .revents = 0});
        }
      }
      if (polled_.empty()) return;
      const auto left =
          std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      ::poll(polled_.data(), polled_.size(), static_cast<int>(std::max(left, 0ms).count()));
    }
  }

  LineServerOptions options_;
  ListeningSocket listening_;
  Descriptor wake_;
  LineRing outbox_;  ///< from the session to the server's thread
  LineRing inbox_;   ///< back
  std::atomic<bool> closing_{false};
  std::atomic<std::size_t> count_{0};

  // From here on the server's thread only.
  std::vector<Client> clients_;
  std::vector<std::pair<std::string, std::string>> newest_;  ///< kind, line
  std::vector<pollfd> polled_;
  std::uint32_t last_number_ = 0;
  bool resting_ = false;  ///< new clients are not looked for, for we could not take them

  std::thread thread_;
};

LineServer::LineServer(const std::filesystem::path& socket, const LineServerOptions& options)
    : work_{std::make_unique<Work>(socket, options)} {}

LineServer::~LineServer() = default;

bool LineServer::publish(std::string_view kind, std::string_view line) noexcept {
  return work_->hand_over(kEverybody, kind, line);
}

bool LineServer::answer(std::uint32_t client, std::string_view line) noexcept {
  return work_->hand_over(client, "", line);
}

std::optional<ReceivedLine> LineServer::next_line() {
  return work_->next_line();
}

std::size_t LineServer::clients() const noexcept {
  return work_->clients();
}

}  // namespace bimodal::runner
