"""Long computations: interruption, time limits, progress, threads."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
import typing

import numpy as np
import pytest
import strata_csg as st

SLOW = "STRATA_SLOW_BUILD" in os.environ

#: From the request to the exception.
SOON = 1.0 if SLOW else 0.1


def interrupt_after(seconds: float) -> tuple[threading.Thread, list[float]]:
    sent: list[float] = []

    def send() -> None:
        time.sleep(seconds)
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=send)
    thread.start()
    return thread, sent


def test_ctrl_c_stops_an_operation(slow_solids):
    thread, sent = interrupt_after(0.3)
    with pytest.raises(KeyboardInterrupt):
        st.union(slow_solids)
    stopped = time.perf_counter()
    thread.join()
    assert stopped - sent[0] < SOON
    assert (slow_solids[0] & slow_solids[0]).triangles.shape[0] > 0  # all is well


def test_a_handler_of_its_own(slow_solids):
    class Stop(Exception):
        pass

    def handler(number: int, frame: object) -> None:
        raise Stop

    before = signal.signal(signal.SIGALRM, handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(Stop):
            st.union(slow_solids)
    finally:
        signal.signal(signal.SIGALRM, before)


def test_a_handler_that_goes_on():
    seen = []
    before = signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
    try:
        solids = [st.torus(3, 1, 200, 100).rotated((1, 2, 3), 9.0 * i) for i in range(8)]
        expected = st.union(solids)
        thread, _ = interrupt_after(0.05)
        assert np.array_equal(st.union(solids).triangles, expected.triangles)
        thread.join()
    finally:
        signal.signal(signal.SIGINT, before)
    assert seen == [signal.SIGINT]


def test_handlers_are_as_before(slow_solids):
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    with pytest.raises(TimeoutError):
        st.union(slow_solids, timeout=0.05)
    with pytest.raises(KeyboardInterrupt):
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(1)


def test_time_limits(slow_solids):
    begin = time.perf_counter()
    with pytest.raises(TimeoutError):
        st.union(slow_solids, timeout=0.2)
    assert time.perf_counter() - begin < 0.2 + SOON
    assert st.union(slow_solids[:1], timeout=60) == slow_solids[0]
    for timeout in (0, -1, float("nan")):
        with pytest.raises(ValueError, match="timeout: expected a positive number"):
            st.union(slow_solids, timeout=timeout)


def ring() -> st.Solid:
    return st.torus(3, 1, 160, 80)


def ball_and_its_place() -> list[st.Solid]:
    ball = st.sphere(2, 200)
    return [ball, st.box((-3, -3, -3), (3, 3, 3)) - ball]


#: By name, and what makes their arguments.
LONG: dict[str, tuple[typing.Callable[..., object], typing.Callable[[], tuple[object, ...]]]] = {
    "sum": (st.minkowski_sum, lambda: (st.torus(3, 1, 40, 30), st.torus(2, 1, 24, 16))),
    "sum of convex": (st.minkowski_sum, lambda: (st.sphere(2, 60), st.sphere(1, 60))),
    "erosion": (st.erosion, lambda: (ring(), st.sphere(0.3, 24))),
    "offset": (st.offset, lambda: (ring(), 0.1)),
    "hull": (st.convex_hull, lambda: (np.random.default_rng(1).normal(size=(300_000 if SLOW else 1_000_000, 3)),)),
    "contact": (st.contacts, lambda: (ball_and_its_place(),)),
    "overlap": (st.contacts, lambda: ([ring(), ring().translated((1, 1, 0.5))],)),
}


@pytest.mark.parametrize("name", LONG)
def test_ctrl_c_stops_every_long_computation(name):
    """At several times, so that it meets several stages."""
    compute, make_arguments = LONG[name]
    arguments = make_arguments()
    begin = time.perf_counter()
    compute(*arguments)
    whole = time.perf_counter() - begin
    for share in (0.2, 0.6) if SLOW else (0.1, 0.3, 0.5, 0.7, 0.9):
        thread, sent = interrupt_after(share * whole)
        stopped = None
        try:
            compute(*arguments)
        except KeyboardInterrupt:
            stopped = time.perf_counter()
        try:  # where it was quicker this time
            thread.join()
        except KeyboardInterrupt:
            thread.join()
        if stopped is not None:
            assert stopped - sent[0] < SOON, share


def test_making_a_solid_can_be_stopped():
    ball = st.sphere(1, 2000)
    mesh = st.Mesh(np.array(ball.vertices), np.array(ball.triangles))
    with pytest.raises(TimeoutError):
        st.Solid(mesh, timeout=0.02)


def test_progress():
    a = st.sphere(1, 200)
    b = a.translated((0.5, 0, 0))
    seen: list[float] = []
    st.union([a, b], progress=seen.append)
    assert seen == sorted(seen) and seen[-1] == 1 and len(seen) > 2
    st.union([a, b], progress=True)
    st.union([a, b], progress=False)
    with pytest.raises(TypeError, match="progress: expected None, True, or a callable"):
        st.union([a, b], progress=3)


def test_progress_that_raises():
    a = st.sphere(1, 200)

    def stop(fraction: float) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        st.union([a, a.translated((0.5, 0, 0))], progress=stop)


def test_progress_that_computes():
    a = st.sphere(1, 100)
    volumes = []
    st.union([a, a.translated((0.5, 0, 0))], progress=lambda f: volumes.append((st.box((0, 0, 0), (1, 1, 1)) | a).volume))
    assert len(set(volumes)) == 1


def test_the_lock_is_released(slow_solids):
    ticks = 0
    running = True

    def tick() -> None:
        nonlocal ticks
        while running:
            ticks += 1
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    with pytest.raises(TimeoutError):
        st.union(slow_solids, timeout=0.5)
    running = False
    thread.join()
    assert ticks > 50


def test_ten_threads():
    a = st.sphere(1, 40)
    solids = [a.translated((i / 7, 0, 0)) for i in range(10)]
    expected = [a | s for s in solids]
    results: list[list[bool]] = [[] for _ in solids]

    def work(i: int) -> None:
        for k in range(10):
            j = (i + k) % 10
            results[i].append(np.array_equal((a | solids[j]).triangles, expected[j].triangles))
            results[i].append((a & solids[j]).nearest_volume >= 0)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(10)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(len(r) == 20 and all(r) for r in results)


def test_signals_that_never_stop_coming():
    seen = []
    before = signal.signal(signal.SIGALRM, lambda number, frame: seen.append(number))
    try:
        solids = [st.torus(3, 1, 200, 100).rotated((1, 2, 3), 9.0 * i) for i in range(8)]
        expected = st.union(solids)
        signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
        assert np.array_equal(st.union(solids).triangles, expected.triangles)
        with pytest.raises(TimeoutError):
            st.union([s.translated((i, 0, 0)) for s in solids for i in range(9)], timeout=0.3)
        thread, sent = interrupt_after(0.1)
        with pytest.raises(KeyboardInterrupt):
            st.union([s.translated((i / 9, 0, 0)) for s in solids for i in range(9)])
        thread.join()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert len(seen) > 3


def test_signals_that_come_while_a_handler_runs():
    seen = []
    is_within = False

    def handler(number: int, frame: object) -> None:
        nonlocal is_within
        seen.append(number)
        if is_within:
            return
        is_within = True
        time.sleep(0.03)
        is_within = False

    before = signal.signal(signal.SIGALRM, handler)
    try:
        solids = [st.torus(3, 1, 200, 100).rotated((1, 2, 3), 9.0 * i) for i in range(8)]
        expected = st.union(solids)
        signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
        for _ in range(3):
            assert np.array_equal(st.union(solids).triangles, expected.triangles)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert len(seen) > 3


def test_handlers_that_a_callback_sets_stay():
    a = st.sphere(1, 200)
    try:
        st.union([a, a.translated((0.5, 0, 0))], progress=lambda f: signal.signal(signal.SIGINT, signal.SIG_IGN))
        os.kill(os.getpid(), signal.SIGINT)  # is ignored
        time.sleep(0.01)
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)


STORM = """
import signal, sys
import strata_csg as st
cube = st.box((0, 0, 0), (1, 1, 1))
complex_ = st.SelectiveComplex(cube)
vertices, triangles = cube.vertices, cube.triangles[1:]
def attempt():
    try:
        st.Solid((vertices, triangles))
    except st.InputError:
        pass
complex_.volume, attempt()  # what is imported when it is used
armed = False
def stop(number, frame):
    global armed
    if armed:
        armed = False
        raise KeyboardInterrupt
signal.signal(signal.SIGALRM, stop)
signal.setitimer(signal.ITIMER_REAL, 0.0005, 0.0005)
count = 0
while count < 300:
    try:
        while True:
            armed = True  # some interrupts end in callbacks of the interpreter, which swallow them
            complex_.volume
            attempt()
    except KeyboardInterrupt:
        count += 1
signal.setitimer(signal.ITIMER_REAL, 0)
print("well")
"""

SHUTDOWN = """
import threading, time
import strata_csg as st
a = st.sphere(1, 60)
def work():
    while True:
        a.volume
        st.union([a, a.translated((0.5, 0, 0))], progress=lambda f: None)
for _ in range(4): threading.Thread(target=work, daemon=True).start()
time.sleep(0.3)
print("well")
"""


@pytest.mark.parametrize("program", [STORM, SHUTDOWN], ids=["interrupts", "threads at the end"])
def test_the_process_ends_well(program):
    for _ in range(3):
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120, check=False)
        assert (done.returncode, done.stdout) == (0, "well\n"), done.stderr
