import json
import os
import subprocess
import sys

import pytest

import gearwright
from gearwright import catalog


def python(*arguments, **environment):
    return subprocess.run(
        [sys.executable, *arguments],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        env={**os.environ, **environment},
    )


def test_help_lists_every_command_of_the_catalog(run):
    outcome = run("--help")
    assert outcome.code == 0
    for name in {element.command for element in catalog.ELEMENTS} | {"properties", "demo"}:
        assert name in outcome.out
    assert "Exit codes" in outcome.out


def test_help_loads_no_numpy():
    script = (
        "import sys; from gearwright.cli import main; code = main(['--help']);"
        "heavy = {'numpy', 'scipy', 'numba', 'matplotlib'} & set(sys.modules);"
        "print('heavy:', sorted(heavy), 'code:', code)"
    )
    assert "heavy: [] code: 0" in python("-c", script).stdout


def test_version(run):
    outcome = run("--version")
    assert (outcome.code, outcome.out.strip()) == (0, gearwright.__version__)


def test_module_runs_as_the_script_does():
    done = python("-m", "gearwright", "--version")
    assert (done.returncode, done.stdout.strip()) == (0, gearwright.__version__)


def test_an_unknown_command_names_the_nearest_and_all(run):
    outcome = run("bevle", "--teeth", 3)
    assert outcome.code == 2
    assert outcome.err.startswith("Unknown command: bevle. Did you mean bevel? The commands are")
    assert "properties" in outcome.err
    assert "gearwright --help" in outcome.err


def test_an_unknown_option_suggests_the_nearest(run):
    outcome = run("bevel", "--teth", 16, 20)
    assert outcome.code == 2
    assert "--teth" in outcome.err
    assert "Did you mean --teeth?" in outcome.err
    assert "`gearwright bevel --help`" in outcome.err


def test_a_reader_who_leaves_early_is_no_error():
    script = "from gearwright.cli import main; import sys; sys.exit(main())"
    command = [sys.executable, "-c", script, "--help"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        process.stdout.close()
        err = process.stderr.read()
        process.wait(timeout=60)
    assert "Traceback" not in err


def test_an_interrupt_is_quiet(run, monkeypatch):
    def interrupted(source):
        raise KeyboardInterrupt

    monkeypatch.setattr(catalog, "load", interrupted)
    monkeypatch.setattr("gearwright.cli.app.build", lambda: interrupted)
    outcome = run("bevel")
    assert (outcome.code, outcome.err) == (130, "")


@pytest.mark.parametrize("debug", ["0", "1"])
def test_an_internal_error_asks_for_a_report(run, monkeypatch, debug):
    def broken(words):
        raise ZeroDivisionError("0 teeth")

    monkeypatch.setenv("GEARWRIGHT_DEBUG", debug)
    monkeypatch.setattr("gearwright.cli.app.build", lambda: broken)
    outcome = run("bevel", "--teeth", "a b")
    assert outcome.code == 3
    assert "gearwright bevel --teeth 'a b'" in outcome.err
    assert "ZeroDivisionError: 0 teeth" in outcome.err
    assert ("Traceback" in outcome.err) == (debug == "1")


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (FileNotFoundError(2, "No such file or directory", "a.stl"), 2),
        (PermissionError(13, "Permission denied", "a.stl"), 3),
        (OSError(28, "No space left on device", "a.stl"), 3),
        (gearwright.MachineError("a.stl: the disk is full"), 3),
        (gearwright.FileError("a.stl: empty"), 2),
        (MemoryError(), 3),
    ],
)
def test_exit_codes_tell_the_input_from_the_machine(run, monkeypatch, error, code):
    def failing(words):
        raise error

    monkeypatch.setattr("gearwright.cli.app.build", lambda: failing)
    outcome = run("bevel")
    assert outcome.code == code
    assert "Traceback" not in outcome.err
    assert "a.stl: " in outcome.err or "tolerance" in outcome.err


def test_a_code_page_without_greek_stops_no_answer():
    environment = {**os.environ, "PYTHONIOENCODING": "cp1252"}
    command = [sys.executable, "-m", "gearwright", *"bevel --teeth 16 20 --module 3 --face-width 10".split()]
    table = subprocess.run(command, env=environment, capture_output=True, check=True).stdout.decode("cp1252")
    assert "pitch angle" in table
    document = subprocess.run([*command, "--json"], env=environment, capture_output=True, check=True).stdout
    assert json.loads(document)["gear"]["sizes"]["pitch_angle"]["symbol"] == "δ"


def test_a_closed_stdout_is_no_fault():
    command = f"{sys.executable} -m gearwright spur --teeth 16 --module 3 --face-width 10 >&-"
    assert subprocess.run(["/bin/sh", "-c", command], check=False, capture_output=True).returncode == 0


def test_a_reader_who_leaves_a_help_page_is_no_fault():
    command = f"{sys.executable} -m gearwright bevel --help | true; exit ${{PIPESTATUS[0]}}"
    assert subprocess.run(["/bin/bash", "-c", command], check=False, capture_output=True).returncode == 0
