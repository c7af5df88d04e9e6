"""python3 -m unittest discover --start-directory tools/bench/driver --pattern '*_test.py'"""

import math
import unittest

import comparison
import report
import rightness
import runs
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


class Stages(unittest.TestCase):
    def test_shares_and_what_the_second_thread_brings(self):
        alone = measured("strata", 10, 4.0, stages={"intersect": 6.0, "subdivide": 3.9, "validate": 0.1})
        together = measured("strata", 5, 4.0, threads=2, stages={"intersect": 3.0, "subdivide": 1.9, "validate": 0.1})
        results = {"settings": {"threads": [1, 2]}, "cases": [case(alone, together, volume=4.0)]}
        row = report.stage_table(results).splitlines()[2]
        self.assertEqual(row, "| x20k | 0 % | 0 % | 60 % (2.0) | 38 % (2.1) | 0 % | 0 % | 0 % | 2 % |")


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


class Runs(unittest.TestCase):
    def run_of(self, *cases, commit="abc", peers=("manifold",)):
        facts = {"commit": commit, "processor": "p", "cpus": 2, "system": "s", "compiler": "c", "flags": "f"}
        facts |= {"date": "today", "memory_gb": 24, "load_at_start": 0.1, "checks": "OFF"}
        settings = {"repetitions": 5, "budget": 5, "timeout": 20, "threads": [1]}
        made = {"machine": facts, "settings": settings, "peers": {peer: peer.title() for peer in peers}}
        return made | {"versions": {}, "missing_peers": {}, "skipped_cases": {}, "cases": list(cases)}

    def merged(self, *pairs):
        """Of runs in which Strata and Manifold take so long."""
        made = [case(measured("strata", ours, 4.0), measured("manifold", theirs, 4.0)) for ours, theirs in pairs]
        return runs.merged([self.run_of(one) for one in made])

    def test_times_are_medians_of_medians_and_ratios_medians_within_runs(self):
        whole = self.merged((1, 10), (2, 8), (3, 9))
        one = whole["cases"][0]
        self.assertEqual(comparison.our_time(one, 1), 2)
        self.assertEqual(comparison.ratio(one, 1), 4)  # of 10, 4 and 3, not 9 / 2
        self.assertEqual(report.ratio_cell(one, 1), "**4** (3 to 10)")
        self.assertEqual(comparison.floor_ratio(one, 1), 4)
        self.assertIn("measured 3 times", report.markdown(whole))

    def test_a_result_that_is_wrong_once_is_wrong(self):
        right = case(measured("strata", 1, 4.0), measured("manifold", 2, 4.0), volume=4.0)
        wrong = case(measured("strata", 1, 4.0), measured("manifold", 2, 5.0), volume=4.0)
        whole = runs.merged([self.run_of(one) for one in (right, wrong, right)])
        self.assertEqual(comparison.of(whole["cases"][0], "manifold", 1)["status"], "wrong")

    def test_who_is_stopped_in_half_of_the_runs_has_no_time(self):
        done = case(measured("strata", 1, 4.0), measured("manifold", 19, 4.0), volume=4.0)
        late = case(measured("strata", 1, 4.0), stopped("manifold", 20), volume=4.0)
        for cases, status in (((done, late), "timeout"), ((done, late, done), "right")):
            whole = runs.merged([self.run_of(one) for one in cases])
            self.assertEqual(comparison.of(whole["cases"][0], "manifold", 1)["status"], status)

    def test_a_peer_may_be_missing_in_some_runs(self):
        with_cgal = self.run_of(
            case(measured("strata", 1, 4.0), measured("corefine_epick", 5, 4.0), measured("manifold", 2, 4.0)),
            peers=("manifold", "corefine_epick"),
        )
        without = self.run_of(case(measured("strata", 1, 4.0), measured("manifold", 4, 4.0)))
        whole = runs.merged([without, with_cgal])
        self.assertEqual(set(whole["peers"]), {"manifold", "corefine_epick"})
        self.assertEqual(comparison.of(whole["cases"][0], "corefine_epick", 1)["median"], 5)
        self.assertEqual(comparison.ratio(whole["cases"][0], 1), 3)
        self.assertIn("Corefine_Epick was in 1 run only.", report.markdown(whole))

    def test_runs_of_other_commits_or_cases_are_not_combined(self):
        one, other = case(measured("strata", 1, 4.0)), case(measured("strata", 1, 4.0), name="y")
        self.assertIsNone(runs.difference([self.run_of(one), self.run_of(one)]))
        self.assertIn("commit", runs.difference([self.run_of(one), self.run_of(one, commit="def")]))
        self.assertIn("cases", runs.difference([self.run_of(one), self.run_of(other)]))


if __name__ == "__main__":
    unittest.main()
