"""What results carry on from their operands, as asked for on the command line."""
import unittest

from tool import USAGE, ToolTest, cube


class Attributes(ToolTest):
    def setUp(self):
        super().setUp()
        self.a, self.b = self.file("a.off", cube()), self.file("b.off", cube(0.5, 0.5, 0.5))

    def written(self, *arguments):
        self.run_tool(*arguments, "-o", "out.ply", "--attributes", "all")
        with_all = self.path("out.ply").read_bytes()
        self.run_tool(*arguments, "-o", "out.ply", "--attributes", "none")
        return with_all, self.path("out.ply").read_bytes()

    def test_files_without_attributes_give_the_same_with_and_without(self):
        for arguments in (("difference", self.a, self.b), ("eval", "a & b", f"a={self.a}", f"b={self.b}"),
                          ("resolve", self.a), ("round", self.a, "--to", "float32")):
            with self.subTest(arguments=arguments):
                with_all, without = self.written(*arguments)
                self.assertEqual(with_all, without)

    def test_a_material_for_cut_faces(self):
        for arguments in (("difference", self.a, self.b), ("eval", "a - b", f"a={self.a}", f"b={self.b}")):
            for engine in ("arrangement", "layers"):
                for material in ("steel", "#ff8000", "#ff800080"):
                    with self.subTest(arguments=arguments, engine=engine, material=material):
                        if engine != "arrangement" and not self.has_engine(engine):
                            continue
                        self.run_tool(*arguments, "-o", "out.off", "--cut-material", material, "--engine", engine)
                        self.run_tool("check", "out.off")

    def has_engine(self, engine):
        return engine in self.run_tool("union", "--help").stdout.decode().split("--engine")[1].split("--")[0]

    def test_what_is_no_colour_is_refused(self):
        for colour in ("#ff80", "#gg0000", "#", "#ff80001"):
            with self.subTest(colour=colour):
                done = self.run_tool("difference", self.a, self.b, "-o", "out.off", "--cut-material", colour, expect=USAGE)
                self.assertIn("#rrggbb", done.stderr.decode())


if __name__ == "__main__":
    unittest.main()
