#include "loosefit/study/people.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/quantile.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/draws.h"
#include "loosefit/study/plan.h"
#include "support/scratch_folder.h"

namespace loosefit::study {
namespace {

std::vector<double> column(const std::vector<Person>& people, const std::string& measure) {
  std::vector<double> values;
  for (const Person& person : people) values.push_back(person.measures.at(measure));
  return values;
}

double correlation(const std::vector<double>& x, const std::vector<double>& y) {
  double mx = 0, my = 0, xy = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mx += x[i] / static_cast<double>(x.size());
    my += y[i] / static_cast<double>(x.size());
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mx) * (y[i] - my);
    xx += (x[i] - mx) * (x[i] - mx);
    yy += (y[i] - my) * (y[i] - my);
  }
  return xy / std::sqrt(xx * yy);
}

PeopleWish many(const std::string& sex) {
  PeopleWish wish;
  wish.count = 8000;
  wish.sex = sex;
  wish.within = 0.9999;
  return wish;
}

TEST(People, HaveThePercentilesOfTheirStatistics) {
  const Anthropometry ansur = load_anthropometry("ansur-2012");
  const std::vector<Person> women = draw_people(ansur, many("female"), 1);
  const PopulationGroup& group = ansur.groups.front();
  for (std::size_t i = 0; i < group.measures.size(); ++i) {
    const std::vector<double> values = column(women, group.measures[i]);
    const double spread = group.p95[i] - group.p5[i];
    EXPECT_NEAR(quantile(values, 0.05), group.p5[i], 0.02 * spread) << group.measures[i];
    EXPECT_NEAR(quantile(values, 0.50), group.p50[i], 0.02 * spread) << group.measures[i];
    EXPECT_NEAR(quantile(values, 0.95), group.p95[i], 0.03 * spread) << group.measures[i];
  }
}

TEST(People, HaveTheCorrelationsOfTheirStatistics) {
  const std::vector<Person> men = draw_people(load_anthropometry("ansur-2012"), many("male"), 1);
  // Those that were measured; skew costs a little.
  EXPECT_NEAR(correlation(column(men, "chest"), column(men, "waist")), 0.89, 0.02);
  EXPECT_NEAR(correlation(column(men, "waist"), column(men, "hip")), 0.88, 0.02);
  EXPECT_NEAR(correlation(column(men, "height"), column(men, "chest")), 0.25, 0.04);
}

TEST(People, OfASmallerCountAreTheFirstOfALargerOne) {
  const Anthropometry from = load_anthropometry("children-germany");
  PeopleWish few, more;
  few.count = 5;
  more.count = 40;
  const auto a = draw_people(from, few, 9), b = draw_people(from, more, 9);
  for (int i = 0; i < few.count; ++i) {
    EXPECT_EQ(a[i].measures, b[i].measures);
    EXPECT_EQ(a[i].age, b[i].age);
  }
  EXPECT_NE(draw_people(from, few, 10)[0].measures, a[0].measures);
}

TEST(People, AreOfAllGroupsEquallyOften) {
  PeopleWish wish;
  wish.count = 12;
  int women = 0;
  for (const Person& person : draw_people(load_anthropometry("ansur-2012"), wish, 4))
    women += person.sex == 0;
  EXPECT_EQ(women, 6);
}

TEST(People, StayWithinTheShareAskedFor) {
  PeopleWish wish = many("female");
  wish.within = 0.8;
  const PopulationGroup group = load_anthropometry("ansur-2012").groups.front();
  const double score = normal_quantile(0.9) / normal_quantile(0.95);
  const double low = group.p50[1] * std::pow(group.p5[1] / group.p50[1], score);
  const double high = group.p50[1] * std::pow(group.p95[1] / group.p50[1], score);
  for (const double chest :
       column(draw_people(load_anthropometry("ansur-2012"), wish, 1), "chest")) {
    EXPECT_GE(chest, low - 1e-4);
    EXPECT_LE(chest, high + 1e-4);
  }
}

TEST(People, OfAnAgeThatNobodyHasAreRefused) {
  PeopleWish wish;
  wish.age = {95, 99};
  EXPECT_THROW(draw_people(load_anthropometry("ansur-2012"), wish, 1), InvalidInput);
}

TEST(Anthropometry, OfImpossibleCorrelationsIsRefused) {
  const std::string text =
      "source = \"x\"\n[[group]]\nsex = \"female\"\nage = 30\n"
      "measures = [\"height\", \"chest\", \"waist\"]\np5 = [1, 0.8, 0.6]\np50 = [1.6, 0.9, 0.7]\n"
      "p95 = [1.8, 1.1, 0.9]\ncorrelations = [0.9, 0.9, -0.9]\n";
  try {
    parse_anthropometry(text, "x.toml");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("correlations"), std::string::npos) << error.what();
  }
}

struct PeopleFile : ::testing::Test {
  const support::ScratchFolder scratch;
  const std::string path = (scratch / "people.csv").string();
  std::vector<Person> read(const std::string& text) const {
    io::write_text_file(path, text);
    return read_people_csv(path);
  }
  void expect_refused(const std::string& text, const std::string& phrase) const {
    EXPECT_NE(complaint(text).find(phrase), std::string::npos) << complaint(text);
  }
  /// With its hint.
  std::string complaint(const std::string& text) const {
    try {
      read(text);
    } catch (const InvalidInput& error) {
      return std::string(error.what()) + "; " + error.hint();
    }
    return "accepted";
  }
};

TEST_F(PeopleFile, GivesThePeople) {
  const auto people = read("name,sex,age,height,chest\nAda,female,30,1.68,0.9\nBob,0.5,40,1.8,\n");
  ASSERT_EQ(people.size(), 2u);
  EXPECT_EQ(people[0].name, "Ada");
  EXPECT_EQ(people[0].measures.at("chest"), 0.9);
  EXPECT_EQ(people[1].sex, 0.5);
  EXPECT_EQ(people[1].measures.count("chest"), 0u);
}

TEST_F(PeopleFile, IsReadAsSpreadsheetsWriteIt) {
  const auto people = read(
      "\xEF\xBB\xBFname,sex,height\r\n\"Lovelace, Ada\",female,1.68\r\n"
      "\"the \"\"tall\"\" one\",male,1.95\r\n");
  ASSERT_EQ(people.size(), 2u);
  EXPECT_EQ(people[0].name, "Lovelace, Ada");
  EXPECT_EQ(people[1].name, "the \"tall\" one");
}

std::string utf16(const std::string& ascii, bool little, bool mark) {
  std::string bytes = !mark ? "" : little ? "\xff\xfe" : "\xfe\xff";
  for (const char c : ascii) bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
  return bytes;
}

/// A table of the same people with one separator, one decimal sign and one kind of line end.
std::string in_dialect(const std::vector<Person>& people, char separator, char decimal,
                       const std::string& end, bool quoted) {
  const auto field = [&](std::string text) {
    std::replace(text.begin(), text.end(), '.', decimal);
    return quoted ? '"' + text + '"' : text;
  };
  const std::string s(1, separator);
  std::string text = "Name" + s + "SEX" + s + "age" + s + "Height" + s + "upper arm" + end;
  for (const Person& p : people)
    text += field(p.name) + s + (*p.sex > 0.5 ? "M" : "Female") + s +
            field(fmt::format("{}", *p.age)) + s +
            field(fmt::format("{}", p.measures.at("height"))) + s +
            field(fmt::format("{}", p.measures.at("upper_arm"))) + end;
  return text;
}

TEST_F(PeopleFile, OneListOfPeopleIsTheSameInEveryDialect) {
  std::vector<Person> people;
  for (int i = 0; i < 7; ++i)
    people.push_back({fmt::format("p{}", i),
                      i % 2,
                      20 + 7.5 * i,
                      {{"height", 1.5 + 0.0731 * i}, {"upper_arm", 0.25 + 0.0113 * i}}});
  std::vector<std::string> written;
  for (const char separator : {',', ';', '\t'})
    for (const char decimal : {'.', ','})
      for (const char* end : {"\n", "\r\n", "\r"})
        for (const bool quoted : {false, true})
          if (quoted || separator != ',' || decimal != ',')
            written.push_back(in_dialect(people, separator, decimal, end, quoted));
  const std::string excel = in_dialect(people, ';', ',', "\r\n", false);
  written.push_back("\xEF\xBB\xBF" + excel);
  written.push_back("sep=;\r\n" + excel);
  for (const bool little : {false, true})
    for (const bool mark : {false, true}) written.push_back(utf16(excel, little, mark));
  for (const std::string& text : written) {
    SCOPED_TRACE(text.substr(0, 60));
    const std::vector<Person> found = read(text);
    ASSERT_EQ(found.size(), people.size());
    for (std::size_t i = 0; i < people.size(); ++i) {
      EXPECT_EQ(found[i].name, people[i].name);
      EXPECT_EQ(found[i].sex, people[i].sex);
      EXPECT_EQ(found[i].age, people[i].age);
      EXPECT_EQ(found[i].measures, people[i].measures);
    }
  }
}

TEST_F(PeopleFile, AUnitBehindTheNameOfAColumnHolds) {
  const auto person = read("height (cm);chest [mm];waist (m);hip\n168,5;920;0,7;1.0\n").at(0);
  EXPECT_NEAR(person.measures.at("height"), 1.685, 1e-12);
  EXPECT_NEAR(person.measures.at("chest"), 0.92, 1e-12);
  EXPECT_EQ(person.measures.at("waist"), 0.7);
  EXPECT_EQ(person.measures.at("hip"), 1.0);
}

TEST_F(PeopleFile, IsRefusedWithLineAndColumn) {
  expect_refused("name,height,chset\nA,1.7,0.9\n", ":1: chset");
  expect_refused("name,height\nA,170\n", ":2: height");
  expect_refused("name,height\nA,1.7\nA,1.8\n", ":3: name");
  expect_refused("name,height\nA\n", ":2");
  expect_refused("name,chest\nA,0.9\n", "height");
  expect_refused("", "an empty file");
  expect_refused("name,height\n", "nobody");
  expect_refused("name,height,chest,height\nA,1.7,0.9,1.9\n", ":1: height: found the column twice");
  expect_refused("name,height\n\"A,1.7\n", ":2: name: found a quote that is not closed");
  expect_refused("name,height\nA,1,7\n", "save the table with semicolons, or with points");
  expect_refused("name;chest (ells);height\nA;1;1.7\n", "found an unknown column");
  expect_refused("name,sex,height\nA,h,1.7\n", ":2: sex");
  expect_refused("name;height\nA;1.700,5\n", ":2: height");
  expect_refused("<html><body>404</body></html>", "a web page");
  expect_refused("PK\x03\x04 xl/workbook.xml", "an Excel workbook (xlsx)");
  for (const char* value : {"nan", "inf", "-1.7", "1.7m", "1,7", "0x1.8p0"})
    expect_refused("name,height\nA," + std::string(value) + "\n", ":2");
}

// As spreadsheets write it unless told otherwise; it ends in JSON, which is UTF-8.
TEST_F(PeopleFile, InLatin1IsRefused) {
  EXPECT_EQ(read("name,height\nZo\u00eb,1.68\n")[0].name, "Zo\u00eb");
  EXPECT_EQ(complaint("name,height\nZo\xEB,1.68\n"),
            path + ":2: found a name that is not UTF-8, expected UTF-8 (save as CSV UTF-8); ");
  expect_refused("name,height\nAda,1.68\n\"\xC9va, 2\",1.7\n", ":3: found a name");
  expect_refused(
      "gr\xF6\xDF"
      "e,height\nA,1.7\n",
      ":1: gr\\xf6\\xdf");
}

TEST_F(PeopleFile, OfLengthsInAnotherUnitIsRefusedWithAHint) {
  EXPECT_EQ(complaint("name,height\nA,168\n"),
            path +
                ":2: height: found \"168\", expected metres from 0.7 to 2.3; "
                "lengths are in metres: 168 cm is 1.68");
  expect_refused("name,height,chest\nA,1.68,880\n",
                 ":2: chest: found \"880\", expected metres from 0.35 to 1.8; "
                 "lengths are in metres: 880 mm is 0.88");
  expect_refused("name,height\nA,0.2\n", ":2: height: found \"0.2\", expected metres from 0.7");
  EXPECT_EQ(complaint("name,height\nA,0.2\n").find("cm"), std::string::npos);
  EXPECT_EQ(read("name,height\nA,\"1,7\"\n")[0].measures.at("height"), 1.7);
}

// What [body] refuses is refused with the place in the file, and nothing else is.
TEST_F(PeopleFile, TakesTheLengthsThatAScenarioTakes) {
  const auto scenario_takes = [](const std::string& body) {
    try {
      io::parse_scenario("[body]\n" + body, "x.toml");
    } catch (const InvalidInput&) {
      return false;
    }
    return true;
  };
  for (const char* value : {"0.699", "0.7", "2.3", "2.301"})
    EXPECT_EQ(complaint("name,height\nA," + std::string(value) + "\n") == "accepted",
              scenario_takes("height = " + std::string(value)))
        << value;
  for (const char* value : {"0.079", "0.08", "2", "2.001"})
    EXPECT_EQ(complaint("name,height,chest\nA,1.7," + std::string(value) + "\n") == "accepted",
              scenario_takes("measurements = { chest = " + std::string(value) + " }"))
        << value;
}

TEST_F(PeopleFile, WithoutAColumnSaysNothingOfIt) {
  const auto people = read("height,sex\n1.7,male\n1.8,0.4\n");
  EXPECT_EQ(people[0].name, "person 1");
  EXPECT_EQ(people[1].name, "person 2");
  EXPECT_EQ(people[0].sex, 1);
  EXPECT_FALSE(people[0].age);
  EXPECT_FALSE(read("age,height\n50,1.7\n")[0].sex);
  expect_refused("sex,height\n,1.7\n", ":2: sex: found \"\"");
}

// Of whom nothing is said the scenario says it, and no input tells what nobody said.
TEST_F(PeopleFile, LeavesTheScenarioWhatItDoesNotSay) {
  io::write_text_file(path, "name,age,height\nA,50,1.7\n");
  const Plan plan = make_plan(parse_study_file(
      "[study]\nmodalities = [\"ecg\"]\n[scenario.body]\nsex = \"male\"\nage = 20\n"
      "[[axis]]\nname = \"p\"\npeople = { file = \"" +
          path + "\" }\n",
      "study.toml"));
  const scenario::Scenario scenario = io::parse_scenario(plan.cases.at(0).toml, "case.toml");
  EXPECT_EQ(scenario.body.sex, 1);
  EXPECT_EQ(scenario.body.age, 50);
  EXPECT_EQ(plan.study.axes[0].levels[0].inputs,
            (std::map<std::string, double>{{"p.age", 50}, {"p.height", 1.7}}));
}

}  // namespace
}  // namespace loosefit::study
