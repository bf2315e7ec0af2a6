#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/error.h"

struct sqlite3;
struct sqlite3_stmt;

// SQLite behind a few plain calls. Errors are IoError with the file and what SQLite says.
namespace loosefit::study {

/// What is there is no database, is damaged, or has other tables.
class DamagedDatabase : public IoError {
 public:
  using IoError::IoError;
};

class Statement {
 public:
  Statement(sqlite3* database, const std::string& file, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  /// Values for ?1, ?2, …; NaN becomes NULL.
  Statement& bind(int at, const std::string& value);
  Statement& bind(int at, double value);
  Statement& bind(int at, int value);
  /// Next row, or no more.
  bool step();
  /// Carries it out and makes it ready for other values.
  void run();
  int columns() const;
  std::string column_name(int at) const;
  bool is_null(int at) const;
  bool is_text(int at) const;
  std::string text(int at) const;
  double number(int at) const;  ///< NaN for NULL
  int integer(int at) const;

 private:
  sqlite3* database_;
  std::string file_;
  sqlite3_stmt* statement_ = nullptr;
};

class Database {
 public:
  enum class Mode { read, write };
  /// Opens, for writing also makes it. Waits up to a minute for others who write. An empty name is
  /// a database of this process alone, which goes with it.
  Database(const std::filesystem::path& file, Mode mode);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  Statement prepare(const std::string& sql) const;
  void run(const std::string& sql) const;

 private:
  std::string file_;
  sqlite3* handle_ = nullptr;
};

/// All that is done while it lives is in the database as a whole or not at all.
class Transaction {
 public:
  explicit Transaction(const Database& database);
  ~Transaction();  ///< takes back what was not committed
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Database& database_;
  bool open_ = true;
};

}  // namespace loosefit::study
