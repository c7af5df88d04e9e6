"""Files in and out: what cannot be read or written (exit code 3), and that nothing is left half written."""
import os
import pathlib
import unittest

from tool import DATA, FILE, INVALID, ToolTest, cube, off, open_cube


class Files(ToolTest):
    def test_every_writable_format_reads_back_as_the_same_solid(self):
        a, b = self.file("a.off", cube()), self.file("b.off", cube(0.5, 0.5, 0.5))
        self.run_tool("union", a, b, "-o", "reference.off")
        for name, extension in (("stl", "stl"), ("stl-ascii", "stl"), ("obj", "obj"), ("off", "off"), ("ply", "ply"),
                                ("ply-ascii", "ply"), ("ply-big-endian", "ply")):
            with self.subTest(format=name):
                out = self.path(f"{name}.{extension}")
                self.run_tool("union", a, b, "-o", out, "--format", name)
                self.run_tool("compare", out, "reference.off")

    def test_extension_tells_the_format_and_format_overrides_it(self):
        a = self.file("a.off", cube())
        self.run_tool("union", a, a, "-o", "x.obj")
        self.assertIn("\nv ", "\n" + self.path("x.obj").read_text())
        self.run_tool("union", a, a, "-o", "x.txt", "--format", "off")
        self.assertTrue(self.path("x.txt").read_text().startswith("OFF"))

    def test_input_format_overrides_the_extension(self):
        odd = self.file("cube.txt", cube())
        self.run_tool("check", odd, "--input-format", "off")

    def test_standard_input_and_output(self):
        a = self.file("a.off", cube())
        done = self.run_tool("union", "-", a, "-o", "-", "--input-format", "off", "--format", "off",
                             stdin=cube(1).encode())
        self.assertTrue(done.stdout.startswith(b"OFF"))
        self.file("out.off", done.stdout.decode())
        self.run_tool("check", "out.off")

    def test_standard_output_is_binary_stl_unless_told(self):
        a = self.file("a.off", cube())
        out = self.run_tool("union", a, a, "-o", "-").stdout
        self.assertEqual(len(out), 84 + 50 * int.from_bytes(out[80:84], "little"))

    def test_what_cannot_be_read_is_named(self):
        good = self.file("good.off", cube())
        self.file("empty.off", "")
        self.file("words.off", "OFF\n8 12 0\nthis is no number\n")
        self.file("truncated.off", cube()[:-30])
        self.file("index.off", off([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 7)]))
        self.file("unknown.xyzzy", cube())
        os.mkdir(self.path("folder.off"))
        for bad in ("missing.off", "empty.off", "words.off", "truncated.off", "index.off", "unknown.xyzzy", "folder.off"):
            for verb in (("check", bad), ("info", bad), ("compare", good, bad), ("union", good, bad, "-o", "out.off")):
                with self.subTest(verb=verb):
                    self.assertIn(bad, self.run_tool(*verb, expect=FILE).stderr.decode())
        self.assertFalse(self.path("out.off").exists())

    def test_a_limit_of_file_sizes_is_an_error_as_a_full_disk_is(self):
        import resource
        a, b = self.file("a.off", cube()), self.file("b.off", cube(0.5, 0.5, 0.5))
        limit = (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
        done = self.run_tool("union", a, b, "-o", "out.obj", expect=FILE, preexec_fn=limit)
        self.assertIn("out.obj", done.stderr.decode())
        self.assertEqual([f for f in os.listdir(self.folder) if "out" in f], [])

    def test_text_errors_name_the_line(self):
        self.file("words.off", cube().replace("1 0 0\n", "1 0 zero\n", 1))
        self.assertIn("words.off:4", self.run_tool("info", "words.off", expect=FILE).stderr.decode())

    def test_unwritable_targets_are_refused(self):
        a = self.file("a.off", cube())
        os.mkdir(self.path("folder.off"))
        for out in ("no/such/folder/out.off", "folder.off"):
            with self.subTest(out=out):
                self.run_tool("union", a, a, "-o", out, expect=FILE)
        self.assertEqual(self.left_over(), ["a.off", "folder.off"])

    @unittest.skipUnless(pathlib.Path("/dev/full").exists(), "needs /dev/full")
    def test_a_full_disk_is_an_error(self):
        a = self.file("a.off", cube())
        self.run_tool("union", a, a, "-o", "/dev/full", "--format", "off", expect=FILE)
        self.run_tool("union", a, a, "-o", "out.off", "--report", "/dev/full", expect=FILE)
        with open("/dev/full", "wb") as full:
            self.run_tool("union", a, a, "-o", "-", expect=FILE, stdout=full)
            self.run_tool("info", a, expect=FILE, stdout=full)
            self.run_tool("check", a, "--report", "-", expect=FILE, stdout=full)

    def test_a_closed_pipe_is_an_error_not_a_crash(self):
        reader, writer = os.pipe()
        os.close(reader)
        with os.fdopen(writer, "wb") as closed:
            self.run_tool("union", DATA / "sphere.off", DATA / "torus.off", "-o", "-", expect=FILE, stdout=closed)

    def test_a_failure_leaves_an_old_result_alone(self):
        a, bad = self.file("a.off", cube()), self.file("bad.off", open_cube())
        out = self.file("out.off", "yesterday's")
        self.run_tool("union", a, bad, "-o", out, expect=INVALID)
        self.assertEqual(out.read_text(), "yesterday's")
        self.assertEqual(self.left_over(), ["a.off", "bad.off", "out.off"])


if __name__ == "__main__":
    unittest.main()
