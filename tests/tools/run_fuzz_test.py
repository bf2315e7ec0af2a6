"""The table of damaged files must show what fails, crashes, hangs or says nothing."""
import contextlib
import io
import pathlib
import stat
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools"))
import run_fuzz  # noqa: E402

TALLY = ('echo "{\\"format\\": \\"DXF\\", \\"cases\\": $LOOSEFIT_FUZZ_CASES, \\"refused\\": 7, \\"read\\": 2, \\"identical\\": 1, '
         '\\"slowest_ms\\": 3}" >> "$LOOSEFIT_FUZZ_TALLY"')


class RunFuzz(unittest.TestCase):
    def table_of(self, what_it_does, seconds=60):
        """Exit code and table of a program with one fuzz test."""
        with tempfile.TemporaryDirectory() as folder:
            program, table = pathlib.Path(folder) / "test_io", pathlib.Path(folder) / "fuzz.md"
            program.write_text("#!/bin/bash\nif [ \"$1\" = --gtest_list_tests ]; then echo Running main; echo DxfFuzz.; echo '  Reads'; exit 0; fi\n"
                               + what_it_does + "\n")
            program.chmod(program.stat().st_mode | stat.S_IXUSR)
            words = ["run_fuzz", str(program), "--cases", "10", "--table", str(table), "--build", "sanitizers"]
            with mock.patch.object(sys, "argv", words), mock.patch.object(run_fuzz, "SECONDS", seconds), \
                    mock.patch.object(run_fuzz, "SECONDS_PER_FILE", 0), contextlib.redirect_stdout(io.StringIO()):
                return run_fuzz.main(), table.read_text()

    def test_counts_of_a_format_that_holds(self):
        code, table = self.table_of(TALLY)
        self.assertEqual(code, 0)
        self.assertIn("| DXF | 10 | 7 | 2 | 1 | 3 | holds |", table)
        self.assertIn("| all | 10 | 7 | 2 | 1 |", table)

    def test_a_failure_is_told_with_its_place(self):
        code, table = self.table_of(TALLY + "\necho 'dxf_fuzz_test.cpp:30: Failure'\nexit 1")
        self.assertEqual(code, 1)
        self.assertIn("fails: dxf_fuzz_test.cpp:30: Failure", table)

    def test_a_crash_a_hang_and_silence_are_told(self):
        for what, told in (("kill -SEGV $$", "crash (exit -11)"), ("exec sleep 30", "hangs"), ("true", "crash (exit 0)")):
            code, table = self.table_of(what, seconds=1)
            self.assertEqual(code, 1, what)
            self.assertIn(told, table)


if __name__ == "__main__":
    unittest.main()
