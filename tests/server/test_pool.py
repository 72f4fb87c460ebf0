import asyncio
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from gearwright.server.files import Files
from gearwright.server.job import Rank
from gearwright.server.outcomes import BusyError, JobCancelledError, JobFailedError, JobRefusedError
from gearwright.server.pool import Pool

from . import work

SECONDS = 60.0


def source(function):
    return f"{work.__name__}:{function.__name__}"


def in_pool(doing, size=1, **options):
    """Runs a coroutine function of a pool, and ends the pool."""

    async def whole():
        pool = Pool(size, warm=None, **options)
        pool.start()
        try:
            return await asyncio.wait_for(doing(pool), SECONDS)
        finally:
            await pool.close()

    return asyncio.run(whole())


async def taken(job):
    return [answer async for answer in job]


def alive(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


async def gone(pid):
    """Waits until a process has ended."""
    while alive(pid):
        await asyncio.sleep(0.02)


def test_linear_algebra_has_the_thread_that_works_unless_somebody_says_otherwise():
    async def doing(pool):
        (answer,) = await taken(pool.submit(source(work.multiply), {}, seconds=SECONDS))
        return answer["threads"]

    threads = in_pool(doing)
    assert threads == 1 + int(os.environ["OPENBLAS_NUM_THREADS"])  # and one that hears what is cancelled


def test_answers_come_one_by_one_while_the_job_still_runs():
    async def doing(pool):
        job = pool.submit(source(work.sleep), {}, seconds=SECONDS)
        first = await anext(aiter(job))
        assert alive(first["pid"])
        return pool.numbers.busy, job.ended.is_set()

    assert in_pool(doing) == (1, False)


def test_jobs_are_begun_in_the_order_they_came_by_as_many_workers_as_there_are():
    async def doing(pool):
        jobs = [pool.submit(source(work.count), {"to": 2, "pause": 0.05}, seconds=SECONDS) for _ in range(6)]
        ended = []

        async def follow(number):
            found = await taken(jobs[number])
            ended.append(number)
            return {answer["pid"] for answer in found}

        pids = await asyncio.gather(*(follow(k) for k in range(6)))
        assert all(len(own) == 1 for own in pids)
        return ended, set.union(*pids)

    ended, pids = in_pool(doing, size=2, spares=1)
    assert all(abs(place - number) <= 1 for place, number in enumerate(ended))
    assert len(pids) <= 3


def test_a_spare_worker_does_no_job_while_others_do_them():
    async def doing(pool):
        while pool.numbers.alive < 3:
            await asyncio.sleep(0.02)
        jobs = [pool.submit(source(work.sleep), {}, seconds=SECONDS) for _ in range(3)]
        await anext(aiter(jobs[0]))
        await anext(aiter(jobs[1]))
        return pool.numbers

    numbers = in_pool(doing, size=2, spares=1)
    assert (numbers.busy, numbers.waiting) == (2, 1)


def test_a_job_cancelled_between_two_answers_leaves_its_worker_alive():
    async def doing(pool):
        job = pool.submit(source(work.count), {"to": 1000, "pause": 0.01}, seconds=SECONDS)
        pid = (await anext(aiter(job)))["pid"]
        job.cancel()
        with pytest.raises(JobCancelledError):
            await taken(job)
        again = await taken(pool.submit(source(work.count), {"to": 1}, seconds=SECONDS))
        return pid, again[0]["pid"], pool.numbers.replaced

    pid, after, replaced = in_pool(doing, grace=20.0)
    assert (after, replaced) == (pid, 0)


def test_a_job_that_comes_to_no_answer_is_cancelled_with_its_worker():
    async def doing(pool):
        job = pool.submit(source(work.sleep), {}, seconds=SECONDS)
        pid = (await anext(aiter(job)))["pid"]
        job.cancel()
        with pytest.raises(JobCancelledError):
            await taken(job)
        await gone(pid)
        again = await taken(pool.submit(source(work.count), {"to": 1}, seconds=SECONDS))
        return pid, again[0]["pid"], pool.numbers.replaced

    pid, after, replaced = in_pool(doing)
    assert after != pid
    assert replaced == 1


def test_a_job_that_waits_is_cancelled_before_it_is_begun():
    async def doing(pool):
        first = pool.submit(source(work.sleep), {}, seconds=SECONDS)
        second = pool.submit(source(work.count), {"to": 1}, seconds=SECONDS)
        await anext(aiter(first))
        second.cancel()
        with pytest.raises(JobCancelledError):
            await taken(second)
        return pool.numbers

    numbers = in_pool(doing)
    assert (numbers.busy, numbers.waiting, numbers.replaced) == (1, 0, 0)


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGSEGV])
def test_a_lost_worker_fails_its_job_and_is_replaced(how):
    async def doing(pool):
        job = pool.submit(source(work.die), {"signal": how}, seconds=SECONDS)
        pid = (await anext(aiter(job)))["pid"]
        with pytest.raises(JobFailedError, match="was lost") as failed:
            await taken(job)
        assert failed.value.lost
        again = await taken(pool.submit(source(work.count), {"to": 3}, seconds=SECONDS))
        return pid, [answer["k"] for answer in again], pool.numbers.replaced

    _, found, replaced = in_pool(doing)
    assert (found, replaced) == ([0, 1, 2], 1)


def test_a_worker_lost_while_it_is_idle_is_replaced():
    async def doing(pool):
        pid = (await taken(pool.submit(source(work.count), {"to": 1}, seconds=SECONDS)))[0]["pid"]
        os.kill(pid, signal.SIGKILL)
        while pool.numbers.replaced == 0:
            await asyncio.sleep(0.02)
        return pid, (await taken(pool.submit(source(work.count), {"to": 1}, seconds=SECONDS)))[0]["pid"]

    before, after = in_pool(doing)
    assert before != after


def test_memory_is_bounded_and_its_lack_told():
    async def doing(pool):
        job = pool.submit(source(work.hog), {"bytes": 4 << 30}, seconds=SECONDS)
        with pytest.raises(JobFailedError, match="not enough memory") as failed:
            await taken(job)
        small = await taken(pool.submit(source(work.hog), {"bytes": 1 << 20}, seconds=SECONDS))
        return failed.value.lost, small, pool.numbers.replaced

    assert in_pool(doing, memory=3 << 30) == (True, [{"taken": 1 << 20}], 1)


def test_a_job_beyond_its_time_is_stopped():
    async def doing(pool):
        job = pool.submit(source(work.sleep), {}, seconds=0.4)
        first = await anext(aiter(job))
        with pytest.raises(JobFailedError, match=r"longer than 0.4 s .* such as fewer teeth"):
            await taken(job)
        await gone(first["pid"])

    in_pool(doing)


def test_a_coarser_tolerance_is_offered_only_to_files_that_have_one(tmp_path):
    async def doing(pool):
        files = Files(tmp_path, pool, seconds=0.2)
        file = files.begin(source(work.sleep), {"request": {}})
        while not file.over:
            await asyncio.sleep(0.02)
        await files.close()
        return file.headline

    assert "such as a coarser tolerance" in in_pool(doing)


def script(*lines):
    """Words that have a process do these lines of a coroutine with a pool of one worker, and its environment."""
    text = (
        "import asyncio\n"
        "from gearwright.server.pool import Pool\n"
        "async def main():\n"
        "    pool = Pool(1, warm=None)\n"
        "    pool.start()\n" + "".join(f"    {line}\n" for line in lines) + "if __name__ == '__main__':\n"
        "    asyncio.run(main())\n"
    )
    path = os.pathsep.join([*filter(None, sys.path), str(Path.cwd())])
    return [sys.executable, "-c", text], {**os.environ, "PYTHONPATH": path}


@pytest.mark.parametrize("debugging", ["", "1"])
def test_warnings_of_workers_reach_the_terminal_only_of_those_who_look_for_faults(debugging):
    asked = f"print([one async for one in pool.submit('{work.__name__}:warn', {{}}, seconds=60.0)])"
    words, environment = script(asked, "await pool.close()")
    environment["GEARWRIGHT_DEBUG"] = debugging
    environment.pop("PYTHONWARNINGS", None)
    told = subprocess.run(words, capture_output=True, text=True, env=environment, timeout=60, check=False)
    assert told.stdout == "[{'warned': True}]\n", told.stderr
    assert ("RuntimeWarning: of a division" in told.stderr) == bool(debugging)


def test_refusals_name_the_parameter_and_the_member():
    request = {"design": {"element": "spur", "teeth": [16, 40]}}

    async def doing(pool):
        with pytest.raises(JobRefusedError) as refused:
            await taken(pool.submit(source(work.refuse), request, seconds=SECONDS))
        with pytest.raises(JobRefusedError) as other:
            await taken(pool.submit(source(work.refuse_file), request, seconds=SECONDS))
        return refused.value, other.value, pool.numbers.replaced

    error, other, replaced = in_pool(doing)
    assert error.headline == "Gear cannot be built from these parameters"
    assert [(one["parameter"], one["member"]) for one in error.problems] == [("face_width", 1), (None, None)]
    assert error.problems[0]["message"] == "too thin"
    assert other.problems[0]["message"] == "section.dxf: broken"
    assert replaced == 0


def test_a_fault_says_whose_it_is():
    async def doing(pool):
        with pytest.raises(JobFailedError, match="the fault is its own") as failed:
            await taken(pool.submit(source(work.fault), {}, seconds=SECONDS))
        return failed.value.lost, pool.numbers.replaced

    assert in_pool(doing) == (False, 0)


def test_too_many_that_wait_are_refused():
    async def doing(pool):
        first = pool.submit(source(work.sleep), {}, seconds=SECONDS)
        await anext(aiter(first))
        for _ in range(4):
            pool.submit(source(work.sleep), {}, seconds=SECONDS)
        with pytest.raises(BusyError):
            pool.submit(source(work.sleep), {}, seconds=SECONDS)

    in_pool(doing, most_waiting=4)


@pytest.mark.parametrize("busy", ["sleep", "hold"])
def test_workers_end_with_the_process_that_has_them(busy):
    words, environment = script(
        f"job = pool.submit('{work.__name__}:{busy}', {{}}, seconds=60.0)",
        "print((await anext(aiter(job)))['pid'], flush=True)",
        "await asyncio.sleep(60)",
    )
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment) as server:
        pid = int(server.stdout.readline())
        assert alive(pid)
        server.kill()
        server.wait(30)
        ends = time.monotonic() + 30
        while alive(pid):
            assert time.monotonic() < ends
            time.sleep(0.02)


def test_what_goes_first_has_a_worker_kept_and_overtakes_what_waits():
    async def doing(pool):
        others = [pool.submit(source(work.sleep), {}, seconds=SECONDS) for _ in range(3)]
        await anext(aiter(others[0]))
        holding = pool.submit(source(work.sleep), {}, seconds=SECONDS, rank=Rank.SHOWN)
        await anext(aiter(holding))
        looked_at = pool.submit(source(work.count), {"to": 1}, seconds=SECONDS, rank=Rank.SHOWN)
        before = pool.numbers
        others[0].cancel()  # its worker is free now, and the one that is looked at came after the others
        await taken(looked_at)
        return before, [one.ended.is_set() for one in others]

    before, ended = in_pool(doing, size=2, kept=1, grace=0.0)
    assert (before.busy, before.waiting) == (2, 3)
    assert ended == [True, False, False]


def test_jobs_are_begun_by_rank_and_in_the_order_they_came():
    async def doing(pool):
        holding = pool.submit(source(work.sleep), {}, seconds=SECONDS)
        await anext(aiter(holding))
        ranks = [Rank.OTHER, Rank.BESIDE, Rank.SHOWN, Rank.BESIDE, Rank.SHOWN, Rank.OTHER]
        order = []

        async def follow(number, rank):
            crowded = pool.crowded
            await taken(pool.submit(source(work.count), {"to": 1}, seconds=SECONDS, rank=rank))
            order.append(number)
            return crowded

        following = [asyncio.ensure_future(follow(*one)) for one in enumerate(ranks)]
        await asyncio.sleep(0.1)
        holding.cancel()
        return await asyncio.gather(*following), order

    crowded, order = in_pool(doing, grace=0.0)
    assert crowded == [False, False, False, True, True, True]
    assert order == [2, 4, 1, 3, 0, 5]


def test_what_waits_too_long_turns_away_only_its_like():
    async def doing(pool):
        for _ in range(3):
            pool.submit(source(work.sleep), {}, seconds=SECONDS)
        with pytest.raises(BusyError):
            pool.submit(source(work.sleep), {}, seconds=SECONDS)
        return await taken(pool.submit(source(work.count), {"to": 1}, seconds=SECONDS, rank=Rank.SHOWN))

    assert len(in_pool(doing, size=2, kept=1, most_waiting=3)) == 1


def test_a_job_that_waits_long_is_told_once():
    async def doing(pool):
        holding = pool.submit(source(work.count), {"to": 10, "pause": 0.1}, seconds=SECONDS)
        await anext(aiter(holding))
        waiting = pool.submit(source(work.count), {"to": 1}, seconds=SECONDS)
        at_once, *rest = await asyncio.gather(taken(holding), taken(waiting))
        return at_once, rest[0]

    holding, waiting = in_pool(doing, patience=0.1)
    assert waiting[0] == {"answer": "stage", "text": "waiting for a free worker"}
    assert [one.get("k") for one in waiting[1:]] == [0]
    assert all("k" in one for one in holding)


def test_a_job_that_is_begun_at_once_is_not_told_to_wait():
    async def doing(pool):
        await taken(pool.submit(source(work.count), {"to": 1}, seconds=SECONDS))
        return await taken(pool.submit(source(work.count), {"to": 3, "pause": 0.1}, seconds=SECONDS))

    assert [one["k"] for one in in_pool(doing, patience=0.05)] == [0, 1, 2]
