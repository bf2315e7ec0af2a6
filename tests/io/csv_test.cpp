#include "loosefit/io/csv.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace loosefit::io {
namespace {

/// What spreadsheets make of a cell: the first sign decides (OWASP, CSV injection).
bool is_formula(std::string cell) {
  cell.erase(0, std::min(cell.find_first_not_of(' '), cell.size()));
  for (const std::string sign : {"=", "+", "-", "@", "\t", "\r", "＝", "＋", "－", "＠"})
    if (cell.starts_with(sign)) return true;
  return false;
}

/// The text of a field as any reader of RFC 4180 has it.
std::string plain(const std::string& field) {
  if (!field.starts_with('"')) return field;
  std::string text;
  for (std::size_t i = 1; i + 1 < field.size(); ++i) {
    text += field[i];
    if (field[i] == '"') ++i;
  }
  return text;
}

std::string drawn(std::mt19937& random) {
  static const std::vector<std::string> kParts = {"=", "+", "-", "@", "＝", "＠", "'", "\"", ",",
                                                  ";", " ", "1", "e", "A",  "(",  ")", "ü",  "|"};
  std::string text;
  for (std::size_t n = random() % 7; n > 0; --n) text += kParts[random() % kParts.size()];
  return text;
}

TEST(CsvField, NoNameIsAFormula) {
  std::mt19937 random(21);
  for (int draw = 0; draw < 3000; ++draw) {
    const std::string cell = plain(csv_field(drawn(random)));
    char* end = nullptr;
    const bool number = !cell.empty() && (std::strtod(cell.c_str(), &end), *end == '\0');
    EXPECT_TRUE(number || !is_formula(cell)) << cell;
  }
  for (const char* name : {"\t=1+1", "\r=1", "=cmd|' /C calc'!A0", "@SUM(1)", "+A1", "-2+3", " =1"})
    EXPECT_FALSE(is_formula(plain(csv_field(std::string(name))))) << name;
}

TEST(CsvField, ComesBackAsItWas) {
  std::mt19937 random(22);
  for (int draw = 0; draw < 3000; ++draw) {
    const std::vector<std::string> texts = {drawn(random), drawn(random), drawn(random)};
    std::string line;
    for (const std::string& text : texts) line += (line.empty() ? "x," : ",") + csv_field(text);
    const CsvFields read = csv_fields(line.empty() ? "x" : line);
    ASSERT_TRUE(read.closed) << line;
    ASSERT_GE(read.fields.size(), 3u) << line;
    const std::vector<std::string> back(read.fields.end() - 3, read.fields.end());
    EXPECT_EQ(back, texts) << line;
  }
}

TEST(CsvField, NumbersStayNumbers) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> any(-1000, 1000);
  for (int draw = 0; draw < 200; ++draw) {
    const double value = any(random);
    EXPECT_EQ(std::stod(csv_field(value)), value);
    EXPECT_EQ(csv_field(std::to_string(value)), std::to_string(value)) << "as text, too";
  }
  EXPECT_EQ(csv_field(std::string("-1e-05")), "-1e-05");
}

TEST(CsvField, StaysOneCellWhereSemicolonsPartThem) {
  EXPECT_EQ(csv_field(std::string("a;=1+1")), "\"a;=1+1\"");
}

}  // namespace
}  // namespace loosefit::io
