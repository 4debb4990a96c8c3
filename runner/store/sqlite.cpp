#include "runner/store/sqlite.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runner/store/session_store.hpp"
#include "runner/store/store_error.hpp"

namespace bimodal::runner {

namespace {

[[noreturn]] void fail_to_write(const std::filesystem::path& file) {
  throw StoreError{fmt::format(
      "cannot open the data file '{}' for writing: {}; choose a folder that you may write to"
      " with --data",
      file.string(),
      std::error_code{errno, std::generic_category()}.message())};
}

/// Makes the file before SQLite would, so that it is never readable by others, not even for a
/// moment. An empty file becomes private too.
void make_private(const std::filesystem::path& file) {
  constexpr mode_t kOwnerOnly = 0600;
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kOwnerOnly);
  if (descriptor < 0) fail_to_write(file);

  struct stat state {};

  if (::fstat(descriptor, &state) == 0 && state.st_size == 0) ::fchmod(descriptor, kOwnerOnly);
  ::close(descriptor);
}

/// Which file a name stands for on its disk; 0: none.
std::uint64_t identity_of(const std::string& file) {
  struct stat state {};

  return ::stat(file.c_str(), &state) == 0 ? std::uint64_t{state.st_ino} : 0;
}

/// SQLite calls it after every commit.
int note_log_pages(void* noted, sqlite3* /*connection*/, const char* /*name*/, int pages) {
  *static_cast<int*>(noted) = pages;
  return SQLITE_OK;
}

}  // namespace

void require_place_for(const std::filesystem::path& file) {
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path{"."};
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail_to_write(file);
}

Database::Database(const std::filesystem::path& file, Access access) : file_{file.string()} {
  if (access == Access::Write) {
    make_private(file);
  } else if (!std::filesystem::exists(file)) {
    throw StoreError{fmt::format("cannot read the data file '{}': it does not exist", file_)};
  }
  const int flags = access == Access::Write ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY;
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &connection, flags, nullptr);
  connection_.reset(connection);
  if (code != SQLITE_OK) fail("open");
  constexpr int kPatienceMs = 5'000;
  sqlite3_busy_timeout(connection, kPatienceMs);
  sqlite3_wal_hook(connection, &note_log_pages, log_pages_.get());
  identity_ = identity_of(file_);
}

void Database::require_in_place() const {
  if (identity_of(file_) == identity_) return;
  throw StoreError{fmt::format(
      "the data file '{0}' was moved or deleted while the session ran; put it back, with '{0}-wal' "
      "and '{0}-shm' beside it, before anything opens it",
      file_)};
}

void Database::execute(const char* sql) {
  if (sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail("change");
}

void Database::empty_log() {
  const int code = sqlite3_wal_checkpoint_v2(
      connection_.get(), nullptr, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
  if (code != SQLITE_OK && code != SQLITE_BUSY) fail("change");
}

std::int64_t Database::pragma(const std::string& name) {
  Statement statement{*this, "PRAGMA " + name};
  return statement.step() ? statement.integer(0) : 0;
}

std::int64_t Database::last_row() const {
  return sqlite3_last_insert_rowid(connection_.get());
}

void Database::fail(std::string_view deed) const {
  const int code = connection_ ? sqlite3_errcode(connection_.get()) : SQLITE_NOMEM;
  std::string remedy;
  if (code == SQLITE_NOTADB) remedy = "; it is no bimodal data file: name another with --data";
  if (code == SQLITE_FULL) remedy = "; make room on the disk";
  if (code == SQLITE_READONLY)
    remedy = "; choose a file and folder that you may write to with --data";
  if (code == SQLITE_BUSY) remedy = "; another program holds it: close that first";
  throw StoreError{fmt::format("cannot {} the data file '{}': {}{}",
                               deed,
                               file_,
                               connection_ ? sqlite3_errmsg(connection_.get()) : "out of memory",
                               remedy)};
}

Statement::Statement(Database& database, std::string_view sql) : database_{database} {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(
      database.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) database.fail("read");
}

Statement& Statement::reset() {
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
  next_parameter_ = 1;
  return *this;
}

Statement& Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), next_parameter_++, value));
  return *this;
}

Statement& Statement::bind(double value) {
  check(sqlite3_bind_double(statement_.get(), next_parameter_++, value));
  return *this;
}

Statement& Statement::bind(std::string_view value) {
  check(sqlite3_bind_text64(statement_.get(),
                            next_parameter_++,
                            value.empty() ? "" : value.data(),
                            value.size(),
                            SQLITE_TRANSIENT,
                            SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind_null() {
  check(sqlite3_bind_null(statement_.get(), next_parameter_++));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_.fail("use");
  return false;
}

void Statement::run() {
  while (step()) {
  }
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* const bytes = sqlite3_column_text(statement_.get(), column);
  if (bytes == nullptr) return {};
  const auto length = sqlite3_column_bytes(statement_.get(), column);
  return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(length)};
}

std::optional<double> Statement::optional_real(int column) const {
  return is_null(column) ? std::nullopt : std::optional{real(column)};
}

std::optional<Duration> Statement::optional_duration(int column) const {
  return is_null(column) ? std::nullopt : std::optional{duration(column)};
}

std::optional<std::string> Statement::optional_text(int column) const {
  return is_null(column) ? std::nullopt : std::optional{text(column)};
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) database_.fail("use");
}

Transaction::Transaction(Database& database) : database_{database} {
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (open_) sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace bimodal::runner
