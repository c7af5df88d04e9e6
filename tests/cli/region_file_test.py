"""Pieces and cells in one file, each a group."""
import unittest

from tool import DATA, USAGE, ToolTest, cube, off

SHEET = off([(-9, -9, .5), (9, -9, .5), (9, 9, .5), (-9, 9, .5)], [(0, 1, 2), (0, 2, 3)])


class RegionFiles(ToolTest):
    def setUp(self):
        super().setUp()
        self.file("a.off", cube())
        self.file("sheet.off", SHEET)

    def test_pieces_are_groups_of_an_obj_file(self):
        self.run_tool("decompose", DATA / "bracket.off", "-o", "pieces.obj")
        groups = self.report("info", "pieces.obj")["operands"][0]["groups"]
        self.assertEqual(groups, [f"piece {n}" for n in range(len(groups))])
        self.assertGreater(len(groups), 1)
        # Each is closed, and all together are the solid.
        self.run_tool("resolve", "pieces.obj", "-o", "all.off", "--input", "overlapping")
        self.run_tool("compare", "all.off", DATA / "bracket.off")

    def test_regions_of_files_for_simulation(self):
        self.run_tool("split", "a.off", "sheet.off", "-o", "halves.msh")
        text = self.path("halves.msh").read_text()
        self.assertIn('$PhysicalNames\n2\n2 1 "piece 0"\n2 2 "piece 1"\n$EndPhysicalNames', text)
        self.assertIn("$Nodes\n1 16 1 16\n", text)  # both have the vertices between them
        self.run_tool("cells", "a.off", "sheet.off", "-o", "cells.vtk", "--format", "vtk-ascii")
        text = self.path("cells.vtk").read_text()
        self.assertRegex(text, "CELL_DATA 40\\n(.*\\n)?.*group")

    def test_a_folder_is_a_folder_still(self):
        self.run_tool("split", "a.off", "sheet.off", "-o", "halves")
        self.assertEqual(sorted(p.name for p in self.path("halves").iterdir()), ["piece-0.xoff", "piece-1.xoff", "split.json"])
        self.path("halves.off").mkdir()
        self.run_tool("split", "a.off", "sheet.off", "-o", "halves.off")
        self.assertTrue(self.path("halves.off/split.json").exists())

    def test_formats_without_groups_are_refused(self):
        for name in ("cells.off", "cells.stl", "a.off", "cells.glb"):
            done = self.run_tool("cells", "a.off", "sheet.off", "-o", name, expect=USAGE)
            self.assertIn(f"{name}: the format has no groups", done.stderr.decode())
        self.run_tool("cells", "a.off", "sheet.off", "-o", "cells.txt", "--format", "msh")
        self.assertTrue(self.path("cells.txt").is_dir())

    def test_walls_need_a_folder(self):
        self.run_tool("cells", "a.off", "sheet.off", "-o", "cells.obj", "--walls", expect=USAGE)
        self.assertFalse(self.path("cells.obj").exists())


if __name__ == "__main__":
    unittest.main()
