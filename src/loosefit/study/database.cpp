#include "loosefit/study/database.h"

#include <sqlite3.h>

#include <cmath>
#include <limits>

#include "loosefit/base/error.h"

namespace loosefit::study {
namespace {

constexpr int kWait = 60000;  ///< for others who write [ms]

[[noreturn]] void fail(sqlite3* database, const std::string& file) {
  const std::string message = file + ": " + sqlite3_errmsg(database);
  switch (sqlite3_errcode(database)) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:
    case SQLITE_SCHEMA:
      throw DamagedDatabase(message);
    default:
      throw IoError(message);
  }
}

}  // namespace

Statement::Statement(sqlite3* database, const std::string& file, const std::string& sql)
    : database_(database), file_(file) {
  if (sqlite3_prepare_v2(database, sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK)
    fail(database_, file_);
}

Statement::~Statement() { sqlite3_finalize(statement_); }

Statement& Statement::bind(int at, const std::string& value) {
  if (sqlite3_bind_text(statement_, at, value.data(), static_cast<int>(value.size()),
                        SQLITE_TRANSIENT) != SQLITE_OK)
    fail(database_, file_);
  return *this;
}

Statement& Statement::bind(int at, double value) {
  const int done = std::isfinite(value) ? sqlite3_bind_double(statement_, at, value)
                                        : sqlite3_bind_null(statement_, at);
  if (done != SQLITE_OK) fail(database_, file_);
  return *this;
}

Statement& Statement::bind(int at, int value) {
  if (sqlite3_bind_int(statement_, at, value) != SQLITE_OK) fail(database_, file_);
  return *this;
}

bool Statement::step() {
  const int done = sqlite3_step(statement_);
  if (done == SQLITE_ROW) return true;
  if (done != SQLITE_DONE) fail(database_, file_);
  return false;
}

void Statement::run() {
  while (step()) {
  }
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

int Statement::columns() const { return sqlite3_column_count(statement_); }
std::string Statement::column_name(int at) const { return sqlite3_column_name(statement_, at); }
bool Statement::is_null(int at) const { return sqlite3_column_type(statement_, at) == SQLITE_NULL; }
bool Statement::is_text(int at) const { return sqlite3_column_type(statement_, at) == SQLITE_TEXT; }
std::string Statement::text(int at) const {
  const unsigned char* text = sqlite3_column_text(statement_, at);
  return text ? reinterpret_cast<const char*>(text) : "";
}
double Statement::number(int at) const {
  return is_null(at) ? std::numeric_limits<double>::quiet_NaN()
                     : sqlite3_column_double(statement_, at);
}
int Statement::integer(int at) const { return sqlite3_column_int(statement_, at); }

Database::Database(const std::filesystem::path& file, Mode mode)
    : file_(file.empty() ? "temporary database" : file.string()) {
  const int flags =
      mode == Mode::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  if (sqlite3_open_v2(file.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
    const std::string cause = handle_ ? sqlite3_errmsg(handle_) : "not enough memory";
    sqlite3_close(handle_);
    throw IoError(file_ + ": " + cause);
  }
  sqlite3_busy_timeout(handle_, kWait);
  try {
    // The rollback journal, not WAL: a file system over the network has no shared memory.
    if (mode == Mode::write) run("PRAGMA journal_mode = DELETE; PRAGMA synchronous = FULL");
  } catch (...) {
    sqlite3_close(handle_);
    throw;
  }
}

Database::~Database() { sqlite3_close(handle_); }

Statement Database::prepare(const std::string& sql) const { return {handle_, file_, sql}; }

void Database::run(const std::string& sql) const {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail(handle_, file_);
}

Transaction::Transaction(const Database& database) : database_(database) {
  database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const IoError&) {
    // SQLite has rolled back already, as it does on a full disk.
  }
}

void Transaction::commit() {
  database_.run("COMMIT");
  open_ = false;
}

}  // namespace loosefit::study
