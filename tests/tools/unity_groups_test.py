#!/usr/bin/env python3
"""Tests of tools/unity_groups.py: files are together unless a name of one would meet the other."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools"))
import unity_groups  # noqa: E402


class Groups(unittest.TestCase):
    def groups(self, **texts):
        with tempfile.TemporaryDirectory() as folder:
            sources = []
            for name, text in texts.items():
                path = pathlib.Path(folder) / name.replace("_", ".")
                path.write_text(text)
                if path.suffix == ".cpp":
                    sources.append(path)
            headers = unity_groups.Headers([pathlib.Path(folder)])
            sources = [unity_groups.Source(path, headers) for path in sources]
            return sorted(sorted(s.path.stem for s in group)
                          for group in unity_groups.groups_of(sources))

    def unnamed(self, code):
        return "namespace a {\nnamespace {\n" + code + "\n}  // namespace\n}\n"

    def test_files_that_share_no_name_are_together(self):
        self.assertEqual(self.groups(a_cpp=self.unnamed("int one() { return 1; }"),
                                     b_cpp=self.unnamed("constexpr double kTwo = 2;")), [["a", "b"]])

    def test_equal_names_part_files(self):
        for code in ("int one() { return 1; }", "constexpr double one = 2;", "struct one {};",
                     "using one = int;", "enum class one { x };",
                     "template <class T>\nT one(T x) { return x; }",
                     "const std::vector<int> one = {1, 2};", "int one[] = {1};",
                     "constexpr int zero = 0, one = 1;"):
            with self.subTest(code):
                self.assertEqual(self.groups(a_cpp=self.unnamed("int one(int x) { return x; }"),
                                             b_cpp=self.unnamed(code)), [["a"], ["b"]])

    def test_a_name_that_the_other_takes_from_a_header_parts_them(self):
        self.assertEqual(self.groups(a_cpp=self.unnamed("int one() { return 1; }"),
                                     b_cpp="int two() { return other::one(); }"), [["a"], ["b"]])

    def test_a_name_declared_in_a_header_of_the_other_parts_them(self):
        a = self.unnamed("struct One {};")
        b = '#include "b.h"\nint two() { return 2; }'
        header = "namespace a {\nenum class One { x, y };\nstruct Other { int inside; };\n}"
        self.assertEqual(self.groups(b_h='#include "c.h"', c_h=header, a_cpp=a, b_cpp=b),
                         [["a"], ["b"]])
        self.assertEqual(self.groups(b_h='#include "c.h"', c_h=header, b_cpp=b,
                                     a_cpp=self.unnamed("int inside = 1;")), [["a", "b"]])

    def test_tests_are_told_apart_by_suite_and_name(self):
        a = self.unnamed("TEST(One, First) {}\nTEST_F(Two, First) {}")
        self.assertEqual(self.groups(a_cpp=a, b_cpp=self.unnamed("TEST(One, Second) {}")),
                         [["a", "b"]])
        self.assertEqual(self.groups(a_cpp=a, b_cpp=self.unnamed("TEST_P(Two, First) {}")),
                         [["a"], ["b"]])

    def test_a_file_that_defines_a_macro_stays_alone(self):
        self.assertEqual(self.groups(a_cpp="#define ONE 1\n" + self.unnamed("int one = ONE;"),
                                     b_cpp=self.unnamed("int two = 2;")), [["a"], ["b"]])

    def test_comments_and_texts_do_not_count(self):
        self.assertEqual(self.groups(a_cpp=self.unnamed("int one() { return 1; }"),
                                     b_cpp='// one\nconst char* two() { return "one"; } /* one */'),
                         [["a", "b"]])

    def test_what_is_inside_functions_does_not_count(self):
        self.assertEqual(self.groups(a_cpp=self.unnamed("int f() { int one = 1; return one; }"),
                                     b_cpp=self.unnamed("int g() { int one = 2; return one; }")),
                         [["a", "b"]])

    def test_groups_stay_small(self):
        big = "int f%d() { return 0; }\n" + "//" + "x" * (unity_groups.MOST_BYTES * 2 // 3) + "\n"
        self.assertEqual(self.groups(a_cpp=big % 1, b_cpp=big % 2), [["a"], ["b"]])


if __name__ == "__main__":
    unittest.main()
