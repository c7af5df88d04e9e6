"""python3 -m unittest discover --start-directory tools/bench/driver --pattern '*_test.py'"""

import math
import unittest

import comparison
import report
import rightness
import targets


def measured(engine, median, volume, threads=1, **more):
    family = "cgal" if engine.startswith("corefine") else engine.split("_")[0]
    judged = {"well_formed": True, "closed": True, "volume": volume, "triangles": 12, "vertices": 8}
    fields = {"engine": engine, "family": family, "sequential": family == "cgal", "threads": threads}
    fields |= {"status": "done", "median": median, "warm_up_only": False, "judged": judged, "triangles": 12}
    fields |= {"memory_above_input": 3_000_000, "output_bytes": 1_000_000, "copy_floor": 0.5}
    return fields | more


def stopped(engine, seconds):
    return measured(engine, 0, 0) | {"status": "timeout", "timeout": seconds}


def case(*measurements, name="x20k", group="pair", volume=None, triangles=40_000):
    made = {"name": name, "group": group, "volume": volume, "triangles": triangles, "operands": 2}
    made |= {"about": "two things", "operation": "union", "measurements": list(measurements)}
    rightness.settle(made)
    return made


class Rightness(unittest.TestCase):
    def statuses(self, made):
        return [m["status"] for m in made["measurements"]]

    def test_the_volume_known_by_construction_decides_against_all(self):
        made = case(measured("strata", 1, 2.0), measured("manifold", 1, 3.0), measured("meshlib", 1, 3.0), volume=2.0)
        self.assertEqual(self.statuses(made), ["right", "wrong", "wrong"])

    def test_else_most_families_decide_and_engines_of_one_family_have_one_vote(self):
        made = case(
            measured("trueform_f32", 1, 5.0),
            measured("trueform_f64", 1, 5.0),
            measured("manifold", 1, 4.0),
            measured("strata", 1, 4.0 + 1e-7),
        )
        self.assertEqual(self.statuses(made), ["wrong", "wrong", "right", "right"])

    def test_two_camps_of_one_size_leave_all_unconfirmed(self):
        made = case(measured("strata", 1, 4.0), measured("manifold", 1, 5.0))
        self.assertEqual(self.statuses(made), ["unconfirmed", "unconfirmed"])

    def test_an_open_result_has_no_vote_and_is_wrong(self):
        leaky = measured("manifold", 1, 5.0)
        leaky["judged"]["closed"] = False
        made = case(leaky, measured("trueform_f32", 1, 4.0), measured("strata", 1, 4.0))
        self.assertEqual(self.statuses(made), ["wrong", "right", "right"])
        self.assertEqual(leaky["why"], "not closed")

    def test_nothing_means_no_triangles(self):
        made = case(measured("meshlib", 1, 1e-20), volume=0)
        self.assertEqual(self.statuses(made), ["wrong"])


class Comparison(unittest.TestCase):
    def test_the_ratio_is_that_of_the_fastest_right_peer(self):
        made = case(
            measured("strata", 2, 4.0),
            measured("manifold", 1, 9.0),  # fast and wrong
            measured("meshlib", 6, 4.0),
            measured("trueform_f32", 8, 4.0),
        )
        self.assertEqual(comparison.ratio(made, 1), 3)

    def test_a_sequential_peer_stands_for_any_number_of_threads(self):
        made = case(measured("strata", 2, 4.0, threads=2), measured("corefine_epick", 8, 4.0))
        self.assertEqual(comparison.ratio(made, 2), 4)

    def test_peers_that_were_stopped_give_a_lower_bound(self):
        made = case(measured("strata", 2, 4.0), stopped("corefine_epick", 20), volume=4.0)
        self.assertEqual(comparison.ratio(made, 1), 10)
        self.assertEqual(report.ratio_cell(made, 1), "**> 10**")

    def test_when_all_peers_are_wrong_there_is_no_limit(self):
        made = case(measured("strata", 2, 4.0), measured("manifold", 1, 5.0), volume=4.0)
        self.assertEqual(comparison.ratio(made, 1), math.inf)

    def test_memory_is_beside_the_output(self):
        made = case(measured("strata", 2, 4.0), volume=4.0)
        self.assertEqual(comparison.bytes_per_triangle(made, 1), 50)

    def test_linear_growth_has_exponent_one(self):
        small = case(measured("strata", 1, 4.0), volume=4.0)
        large = case(measured("strata", 64, 4.0), volume=4.0, triangles=64 * 40_000)
        self.assertAlmostEqual(comparison.growth(small, large, 1), 1)


class Targets(unittest.TestCase):
    def row(self, cases, words):
        return next(row for row in targets.table(cases, [1]) if words in row["what"])

    def test_the_worst_case_speaks_for_all(self):
        fast = case(measured("strata", 1, 4.0), measured("manifold", 9, 4.0), name="fast")
        slow = case(measured("strata", 1, 4.0), measured("manifold", 2, 4.0), name="slow")
        row = self.row([fast, slow], "every other pair")
        self.assertEqual(report.held_cell(row["threads"][1], row["unit"]), "**missed**, 2x (slow), 1 of 2")

    def test_a_wrong_result_of_ours_misses_the_target(self):
        wrong = case(measured("strata", 1, 4.0), measured("manifold", 9, 5.0), name="bad", volume=5.0)
        row = self.row([wrong], "every other pair")
        self.assertEqual(report.held_cell(row["threads"][1], row["unit"]), "**missed**, no right result of bad")


if __name__ == "__main__":
    unittest.main()
