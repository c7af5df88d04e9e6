"""strata chain: checkpoints, stops, going on."""
import hashlib
import signal
import subprocess
import time
import unittest

from chain_case import ChainTest, box, matrix
from tool import DATA, FILE, OK, STOPPED, TOOL, USAGE, cube


class Checkpoint(ChainTest):
    def run_chain(self, steps, *arguments, expect=OK, **others):
        document = self.document("steps.json", self.block, steps)
        return self.run_tool("chain", document, *arguments, expect=expect, **others)

    def refused(self, path, message):
        error = self.run_tool("chain", "steps.json", "-o", "no.xoff", "--resume", path, expect=FILE).stderr
        self.assertIn(message, error.decode())
        self.assertFalse(self.path("no.xoff").exists())

    def test_several_processes_are_one(self):
        steps = self.holes(20)
        self.run_chain(steps, "-o", "one.xoff")
        self.run_chain(steps[:5], "-o", "out.off", "--checkpoint", "save")
        for done, until in ((5, 6), (6, 13), (13, 20)):
            document = self.document("steps.json", self.block, steps[:until])
            report = self.report("chain", document, "-o", "out.xoff", "--checkpoint", "save", "--resume", "save")
            self.assertEqual((report["resumed"]["checkpoint"], report["resumed"]["steps_done"]), ("save", done))
            self.assertIsNone(report["start"])
            self.assertEqual([o["path"] for o in report["operands"]], [str(self.path("unit.off"))])  # no other is read
            self.assertEqual([step["index"] for step in report["steps"]], list(range(done, until)))
            self.assertEqual(report["checkpoints"], {"path": "save", "written": 1})
            self.assertEqual(self.mark("save")["done"], until)
        self.run_tool("compare", "out.xoff", "one.xoff")
        # All is done: the checkpoint is the result.
        self.run_tool("chain", "steps.json", "-o", "again.xoff", "--resume", "save")
        self.run_tool("compare", "again.xoff", "one.xoff")
        self.run_tool("compare", "save", "one.xoff", "--input-format", "xoff")
        self.assertFalse(list(self.folder.glob("*.part")))

    def test_an_empty_solid_is_resumed(self):
        steps = [box("intersection", (1, 1, 1), (9, 9, 9)), box("union", (1, 1, 1), (0, 0, "1/3"))]
        self.run_chain(steps[:1], "-o", "out.off", "--checkpoint", "save")
        self.run_chain(steps, "-o", "out.xoff", "--resume", "save")
        self.assertEqual(self.volume("out.xoff"), 1)

    def test_every_so_many_steps_one_is_written(self):
        steps = self.holes(11)
        wrong = [*steps[:7], box("union", (1, 1, 1), (0, 0, 0))]
        wrong[7]["transform"][0] = [1e308, 0, 0, 1e308]
        error = self.run_chain(wrong, "-o", "out.xoff", "--checkpoint", "save", "--checkpoint-every", "3",
                               expect=FILE).stderr.decode()
        self.assertIn("steps.json: steps[7].transform: ", error)
        self.assertEqual(self.mark("save")["done"], 6)
        self.assertFalse(self.path("out.xoff").exists())
        self.run_chain(steps, "-o", "one.xoff")
        report = self.report("chain", "steps.json", "-o", "out.xoff", "--resume", "save", "--checkpoint", "save",
                             "--checkpoint-every", "3")
        self.assertEqual(report["checkpoints"]["written"], 2)  # after 9 and 11
        self.run_tool("compare", "out.xoff", "one.xoff")

    def test_marks_are_the_digests_of_files(self):
        self.run_chain(self.holes(2), "-o", "out.off", "--checkpoint", "save")
        mark = self.mark("save")
        self.assertEqual(mark["files"], [hashlib.sha256(self.path(name).read_bytes()).hexdigest()
                                         for name in ("block.off", "unit.off")])
        first, rest = self.path("save").read_bytes().split(b"\n", 1)
        self.assertEqual(mark["digest"], hashlib.sha256(rest).hexdigest())
        self.assertEqual([m[:2] for m in mark["marks"]], [["start", 0], ["symmetric-difference", 1], ["difference", 1]])

    def test_digests_are_right_for_every_length_about_a_block(self):
        unit = cube()
        for length in range(119, 131):
            text = unit + "#" * (length - len(unit) % 64)
            self.file("unit.off", text)
            self.document("steps.json", {"file": "unit.off"}, [])
            self.run_tool("chain", "steps.json", "-o", "out.off", "--checkpoint", "save")
            self.assertEqual(self.mark("save")["files"], [hashlib.sha256(text.encode()).hexdigest()])

    def test_other_steps_are_refused_with_the_first_that_differs(self):
        steps = self.holes(4)
        self.run_chain(steps, "-o", "out.off", "--checkpoint", "save")

        def changed(k, **others):
            return self.document("steps.json", self.block, [*steps[:k], {**steps[k], **others}, *steps[k + 1:]])

        changed(2, operation="union")
        self.refused("save", "save: belongs to other steps: steps[2].operation is union, was difference")
        changed(3, input="overlapping")
        self.refused("save", "steps[3].input is overlapping, was automatic")
        changed(1, file="block.off")
        self.refused("save", "steps[1].file has other content than then")
        changed(1, transform=matrix())
        self.refused("save", "steps[1].transform is none, was 1/3 0 0 5/3")
        self.document("steps.json", self.block, steps, transforms="rounded")
        self.refused("save", "steps[0].transform is ")
        self.document("steps.json", {"file": "unit.off"}, steps)
        self.refused("save", "start.file has other content than then")
        self.document("steps.json", None, steps)
        self.refused("save", "start is null, was a file")
        self.document("steps.json", self.block, steps[:3])
        self.refused("save", "4 are done, of which the document has 3 only")
        self.document("steps.json", self.block, steps)
        self.file("unit.off", cube().replace("OFF", "OFF # changed"))
        self.refused("save", "steps[0].file has other content than then")

    def test_names_and_labels_do_not_matter(self):
        steps = self.holes(3)
        self.run_chain(steps, "-o", "one.xoff", "--checkpoint", "save")
        self.path("unit.off").rename(self.path("moved.off"))
        renamed = [{**step, "file": "moved.off", "label": "other"} for step in steps]
        self.run_chain(renamed, "-o", "out.xoff", "--resume", "save")
        self.run_tool("compare", "out.xoff", "one.xoff")

    def test_what_is_no_checkpoint_is_refused(self):
        self.run_chain(self.holes(2), "-o", "out.xoff", "--checkpoint", "save")
        self.refused("missing", "missing")
        self.refused("out.xoff", "out.xoff: is no checkpoint of a chain")
        self.refused("steps.json", "is no checkpoint of a chain")
        text = self.path("save").read_text()
        self.refused(self.file("short", text[:-8]), "was changed since it was written")
        self.refused(self.file("moved", text.replace("\n4 4 4\n", "\n4 4 5\n")), "was changed since it was written")
        self.refused(self.file("newer", text.replace('"version":1', '"version":2')), "version: expected 1, found 2")
        self.refused(self.file("broken", text.replace('"version":1', '"version":')), "broken:1: column ")
        self.refused(self.file("fewer", text.replace('"done":2', '"done":1')), "the number of marks")

    def test_a_time_limit_leaves_a_checkpoint(self):
        steps = self.spheres(60)
        done = self.run_chain(steps, "-o", "out.off", "--timeout", "1", "--checkpoint", "save", expect=STOPPED)
        self.assertRegex(done.stderr.decode(),
                         r"time limit of 1 s reached; \d+ of 60 steps are done and in save; no result")
        self.check_stopped(steps)

    def test_a_signal_leaves_a_checkpoint(self):
        steps = self.spheres(60)
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number):
                document = self.document("steps.json", self.block, steps)
                process = subprocess.Popen([TOOL, "chain", document, "-o", "out.off", "--checkpoint", "save",
                                            "--checkpoint-every", "1"], cwd=self.folder, stderr=subprocess.PIPE)
                for _ in range(600):
                    if self.path("save").exists():
                        break
                    time.sleep(0.1)
                process.send_signal(number)
                _, err = process.communicate(timeout=60)
                self.assertEqual(process.returncode, STOPPED, err.decode())
                self.assertRegex(err.decode(), r"interrupted; \d+ of 60 steps are done and in save; no result")
                self.check_stopped(steps)
                self.path("save").unlink()

    def spheres(self, count):
        """Steps that take far longer than these tests wait, all together."""
        self.file("sphere.off", (DATA / "sphere.off").read_text())
        return [{"operation": "xor", "file": "sphere.off", "transform": matrix(at=(f"{k}/1024", "1/3", 0))}
                for k in range(count)]

    def check_stopped(self, steps):
        """Nothing but the checkpoint is left, and it is what so many steps make."""
        self.assertFalse(self.path("out.off").exists())
        self.assertFalse(list(self.folder.glob("*.part")))
        done = self.mark("save")["done"]
        self.assertLess(done, len(steps))
        few = min(done, 2)
        self.run_chain(steps[:few], "-o", "few.xoff", "--checkpoint", "few")
        self.run_chain(steps[:done], "-o", "many.xoff", "--resume", "few")
        self.run_chain(steps[:done], "-o", "resumed.xoff", "--resume", "save")
        self.run_tool("compare", "many.xoff", "resumed.xoff")

    def test_misuse(self):
        self.document("steps.json", self.block, [])
        for arguments in (("--checkpoint-every", "3"), ("--checkpoint", "c", "--checkpoint-every", "0"),
                          ("--checkpoint", "-"), ("--resume", "-"), ("--exact-volumes",), ("--checkpoint", "out.xoff")):
            with self.subTest(arguments=arguments):
                self.run_tool("chain", "steps.json", "-o", "out.xoff", *arguments, expect=USAGE)
        self.run_tool("chain", "steps.json", "-o", "out.xoff", "--checkpoint", "no/such/folder", expect=FILE)
        self.assertEqual(self.left_over(), ["block.off", "steps.json", "unit.off"])


if __name__ == "__main__":
    unittest.main()
