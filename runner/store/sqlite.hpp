#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <sqlite3.h>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// An open SQLite file. All members throw StoreError, which names the file.
class Database {
 public:
  enum class Access { Read, Write };

  /// Write makes the file, readable and writable by its owner only, if it is not there.
  Database(const std::filesystem::path& file, Access access);

  /// Fails if the file was moved or deleted since it was opened: what is written would be lost.
  void require_in_place() const;

  void execute(const char* sql);

  [[nodiscard]] std::int64_t pragma(const std::string& name);

  [[nodiscard]] std::int64_t last_row() const;

  /// How many pages the latest commit left in the log beside the file. SQLite itself never moves
  /// them into the file, which would make one commit in a hundred four times as long.
  [[nodiscard]] int log_pages() const { return *log_pages_; }

  /// Moves what nobody reads any more from the log into the file, so that it is used from its
  /// beginning again.
  void empty_log();

  [[noreturn]] void fail(std::string_view deed) const;

  [[nodiscard]] sqlite3* get() const { return connection_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* connection) const { sqlite3_close(connection); }
  };

  std::string file_;
  std::uint64_t identity_ = 0;                                 ///< of the file on its disk
  std::unique_ptr<int> log_pages_ = std::make_unique<int>(0);  ///< SQLite has its address
  std::unique_ptr<sqlite3, Close> connection_;
};

/// A prepared statement. bind() fills its parameters in order; step() gives a row, if there is one.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);

  /// Forgets what was bound and starts again.
  Statement& reset();

  Statement& bind(std::int64_t value);

  Statement& bind(int value) { return bind(std::int64_t{value}); }

  Statement& bind(bool value) { return bind(std::int64_t{value ? 1 : 0}); }

  Statement& bind(double value);

  Statement& bind(Duration value) { return bind(std::int64_t{value.count()}); }

  Statement& bind(std::string_view value);

  Statement& bind(const std::string& value) { return bind(std::string_view{value}); }

  Statement& bind(const char* value) { return bind(std::string_view{value}); }

  template <typename T>
  Statement& bind(const std::optional<T>& value) {
    return value ? bind(*value) : bind_null();
  }

  /// True while there is a row.
  bool step();

  /// Runs a statement that gives no rows.
  void run();

  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;

  [[nodiscard]] Duration duration(int column) const { return Duration{integer(column)}; }

  [[nodiscard]] std::string text(int column) const;

  /// Absent where the column is null.
  [[nodiscard]] std::optional<double> optional_real(int column) const;
  [[nodiscard]] std::optional<Duration> optional_duration(int column) const;
  [[nodiscard]] std::optional<std::string> optional_text(int column) const;

 private:
  Statement& bind_null();
  void check(int code) const;

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };

  Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int next_parameter_ = 1;
};

/// Rolls back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  Transaction(Transaction&&) = delete;
  Transaction& operator=(Transaction&&) = delete;

  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace bimodal::runner
