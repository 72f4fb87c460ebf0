"""Many files: in their order, by processes, some of them missing, broken or killed."""

import json
import os
import pickle
import signal
import subprocess
import sys
import time
from contextlib import closing

import numpy as np
import pytest

import gearwright
from gearwright.cli.batch import in_order
from gearwright.cli.measuring import Failure, Question, answer
from gearwright.cli.properties import _lost, _processes
from gearwright.cli.summing import Sum

from ..signals import begun_with
from . import work
from .bodies import CORNERS, FACES

NOBODY = "nobody"


def lost(task, code):
    return (NOBODY, task, code)


@pytest.fixture
def boxes(tmp_path):
    """Twelve files, of boxes as high as their numbers, and their names."""
    paths = [tmp_path / f"box{k:02}.stl" for k in range(1, 13)]
    for k, path in enumerate(paths, start=1):
        gearwright.Polyhedron(CORNERS * [1, 1, k], FACES).save(path)
    return paths


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_results_are_in_the_order_of_their_tasks(jobs):
    assert list(in_order(range(13), work.double, jobs, lost)) == list(range(0, 26, 2))


def test_no_tasks_have_no_results():
    assert list(in_order([], work.double, 2, lost)) == []


def test_processes_share_the_tasks():
    assert len(set(in_order(range(12), work.process, 2, lost)) - {os.getpid()}) == 2
    assert set(in_order(range(3), work.process, 1, lost)) == {os.getpid()}


def test_a_killed_process_loses_its_task_only():
    found = list(in_order(range(8), work.double_or_die, 2, lost))
    assert found == [0, 2, 4, (NOBODY, 3, -signal.SIGKILL), 8, 10, 12, 14]


def test_only_so_many_tasks_are_begun_ahead():
    class Tasks(list):
        asked = 0

        def __getitem__(self, number):
            self.asked = max(self.asked, number)
            return super().__getitem__(number)

    tasks = Tasks([1.5, *[0.0] * 1000])  # the others could be done while the first one takes its time
    with closing(in_order(tasks, work.sleep, 2, lost)) as results:
        assert next(results) == 1.5
        assert tasks.asked == 4 * 2 - 1


def test_closing_ends_the_processes_at_once():
    results = in_order([0.0, 60.0, 60.0], work.sleep, 2, lost)
    assert next(results) == 0.0
    start = time.monotonic()
    results.close()
    assert time.monotonic() - start < 5


def test_a_lost_file_is_named_with_the_usual_cause(tmp_path):
    found = _lost(tmp_path / "huge.stl", -9)
    assert found.code == 3
    assert found.message.startswith(f"{tmp_path / 'huge.stl'}: the process that measured it was ended by signal 9; ")
    assert "memory" in found.message
    assert _lost(Failure(code=2, message="m"), -9) == Failure(code=2, message="m")


def test_few_bytes_are_not_worth_a_process(boxes, tmp_path):
    assert _processes(boxes) == 1
    huge = tmp_path / "huge.stl"
    with huge.open("wb") as stream:
        stream.truncate(10**9)  # a hole: takes no space
    assert _processes([huge]) == 1
    assert _processes([*boxes, huge]) == min(os.cpu_count() or 1, len(os.sched_getaffinity(0)), 10)
    assert _processes([tmp_path / "missing.stl"]) == 1


def test_many_files_by_processes_are_as_by_one(run, boxes):
    missing = boxes[0].with_name("missing.stl")
    boxes[3].write_bytes(b"solid no more")
    names = [boxes[0], missing, *boxes[1:]]
    one = run("properties", *names, "--json", "--density", 1000, "--jobs", 1)
    two = run("properties", *names, "--json", "--density", 1000, "--jobs", 2)
    assert (one.code, one.out, one.err) == (two.code, two.out, two.err)
    assert one.code == 2
    assert [json.loads(line)["volume"] for line in one.out.splitlines()] == pytest.approx([1, 2, 3, 5, *range(6, 13)])
    assert "missing.stl: there is no such file" in one.err
    assert f"{boxes[3].name}: " in one.err


def test_a_sum_over_processes(run, boxes):
    *_, total = run("properties", *boxes, "--json", "--sum", "--jobs", 2).out.splitlines()
    found = json.loads(total)
    assert found["volume"] == pytest.approx(78)
    np.testing.assert_allclose(found["bounding_box"], [[0, 0, 0], [1, 1, 12]])


def test_a_folder_stands_for_its_files(run, boxes, tmp_path):
    (tmp_path / "notes.txt").write_text("no body")
    (tmp_path / "deeper").mkdir()
    lines = run("properties", tmp_path, "--json").out.splitlines()
    assert [json.loads(line)["file"] for line in lines] == list(map(str, boxes))
    outcome = run("properties", tmp_path / "deeper")
    assert outcome.code == 2
    assert "deeper: this folder holds no file whose name ends in .stl" in outcome.err


def test_a_list_names_files_from_where_it_is(run, boxes, tmp_path, monkeypatch):
    (tmp_path / "list.txt").write_text(f"box02.stl\n\n{boxes[4]}\r\n")
    monkeypatch.chdir(tmp_path.parent)
    lines = run("properties", f"@{tmp_path / 'list.txt'}", "--json").out.splitlines()
    assert [json.loads(line)["volume"] for line in lines] == pytest.approx([2, 5])


@pytest.mark.parametrize(("text", "said"), [(b"\n", "this list names no file"), (b"\xff", "text in UTF-8")])
def test_a_list_that_is_none_is_refused_and_the_rest_is_done(run, boxes, tmp_path, text, said):
    (tmp_path / "list.txt").write_bytes(text)
    outcome = run("properties", f"@{tmp_path / 'list.txt'}", boxes[0], "--json")
    assert (outcome.code, len(outcome.out.splitlines())) == (2, 1)
    assert said in outcome.err


def gearwright_command(*words):
    return [sys.executable, "-m", "gearwright", "properties", *map(str, words)]


def test_what_is_piped_in_is_one_file(boxes):
    done = subprocess.run(
        gearwright_command("-", "--json"), input=boxes[2].read_bytes(), capture_output=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["volume"] == pytest.approx(3)
    nothing = subprocess.run(gearwright_command("-"), input=b"", capture_output=True, check=False, timeout=120)
    assert nothing.returncode == 2
    assert nothing.stderr.startswith(b"standard input: ")
    assert b"Traceback" not in nothing.stderr


def test_an_interrupt_ends_all_processes_quietly(boxes):
    names = [path for _ in range(400) for path in boxes]
    with (
        begun_with(signal.SIGINT, signal.default_int_handler),
        subprocess.Popen(
            gearwright_command(*names, "--jobs", 2, "--json"),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
        ) as process,
    ):
        process.stdout.readline()
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        out, err = process.communicate(timeout=60)  # all of them hold the pipe of stdout, which ends with the last
    assert (process.returncode, err) == (130, b"")
    assert out.count(b"\n") < len(names) - 1


def test_what_should_not_happen_in_a_worker_is_an_answer(monkeypatch, boxes):
    monkeypatch.setattr("gearwright.solids.model.Model.load", lambda path: 1 / 0)
    found = answer(boxes[0], Question())
    assert found.code == 3
    assert "ZeroDivisionError" in found.message
    monkeypatch.setattr("gearwright.solids.model.Model.load", lambda path: bytes(2**62))
    assert "Not enough memory" in answer(boxes[0], Question()).message


def test_a_sum_of_thousands_keeps_none_of_them(boxes):
    found = answer(boxes[0], Question())
    total = Sum()
    for _ in range(3000):
        total.take(found)
    together = total.total()
    assert together.together.volume == pytest.approx(3000)
    assert len(pickle.dumps(together)) < 2 * len(pickle.dumps(found))
