"""A few damaged files: the program and a Python outlive them all. damaged_files.py does thousands, by hand."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import damaged_files  # noqa: E402
import runs  # noqa: E402  from support, which damaged_files looks in

KERNEL_BREAKS = (126, 148, 203)  # in OpenCASCADE 7.6; other releases may do better
NUMBERS = (*range(12), *KERNEL_BREAKS)


class DamagedFiles(unittest.TestCase):
    def test_the_command_line_says_one_sentence(self):
        for number in NUMBERS:
            with self.subTest(number=number):
                self.assertEqual(damaged_files.run(number, 1e4).fault, "")

    @unittest.skipUnless(damaged_files.has_module(), "the module is not built")
    def test_one_python_outlives_them(self):
        code, said = damaged_files.survive(NUMBERS)
        self.assertEqual((code, len(said)), (0, len(NUMBERS)), said[-1:])
        self.assertTrue(any("export the model again" in line for line in said), said)


if __name__ == "__main__":
    runs.need_shared("cad")
    unittest.main()
