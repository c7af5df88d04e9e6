"""Time limits and signals: exit code 6, and nothing left behind. What nobody reads stops nothing."""
import os
import signal
import subprocess
import time
import unittest

from tool import DATA, INVALID, OK, STOPPED, TOOL, ToolTest, open_cube


class Stop(ToolTest):
    def heavy(self):
        """Arguments for a Boolean that takes far longer than these tests wait."""
        copies = []
        text = (DATA / "sphere.off").read_text().splitlines()
        counts = text[1].split()
        for k in range(40):
            moved = [" ".join([str(float(line.split()[0]) + k / 1024), *line.split()[1:]])
                     for line in text[2:2 + int(counts[0])]]
            copies.append(self.file(f"sphere{k}.off", "\n".join(text[:2] + moved + text[2 + int(counts[0]):]) + "\n"))
        return ("xor", *copies, "-o", self.path("out.off"))

    def test_a_time_limit_stops_the_work(self):
        done = self.run_tool(*self.heavy(), "--timeout", "0.3", expect=STOPPED)
        self.assertIn("time limit", done.stderr.decode())
        self.assertFalse(self.path("out.off").exists())
        self.assertFalse(list(self.folder.glob("*.part")))

    def test_a_time_limit_while_rounding_is_told(self):
        worst = DATA.parent / "tools/bench/worst"
        plates = [f"{name}={worst / f'plate_{plate}.off'}" for name, plate in zip("abcdef", "efghij")]
        done = self.run_tool("eval", "a ^ b ^ c ^ d ^ e ^ f", *plates, "-o", self.path("out.ply"), "--timeout", "0.5", expect=STOPPED)
        self.assertIn("time limit", done.stderr.decode())
        self.assertFalse(self.path("out.ply").exists())

    def test_a_signal_stops_the_work_soon(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number):
                process = subprocess.Popen([TOOL, *map(str, self.heavy())], stderr=subprocess.PIPE)
                time.sleep(0.4)
                process.send_signal(number)
                _, err = process.communicate(timeout=10)
                self.assertEqual(process.returncode, STOPPED, err.decode())
                self.assertFalse(self.path("out.off").exists())

    def test_a_signal_ends_waiting_for_standard_input(self):
        process = subprocess.Popen([TOOL, "info", "-", "--input-format", "off"], stdin=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=5), STOPPED)
        process.stdin.close()
        process.stderr.close()

    def test_a_closed_standard_error_changes_no_exit_code(self):
        broken = self.file("open.off", open_cube())
        for arguments, code in ((("union", broken, broken, "-o", "none.off"), INVALID),
                                (("round", DATA / "sphere.off", "--to", "1", "-o", "out.off", "--progress"), OK)):
            with self.subTest(arguments[0]):
                read, write = os.pipe()
                os.close(read)
                done = subprocess.run([TOOL, *map(str, arguments)], stderr=write, cwd=self.folder, timeout=60)
                os.close(write)
                self.assertEqual(done.returncode, code)
        self.assertTrue(self.path("out.off").exists())

    def test_a_limit_that_is_not_reached_changes_nothing(self):
        self.run_tool("union", DATA / "cube.off", DATA / "cube_beside.off", "-o", "out.off", "--timeout", "60")


if __name__ == "__main__":
    unittest.main()
