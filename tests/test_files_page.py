"""What the page on files says of formats, limits and commands is so."""

import io
import re
import shlex
import sys

import pytest

from gearwright.cli import main
from gearwright.files import instances
from gearwright.files import reading as streams
from gearwright.files.formats import FILE_FORMATS
from gearwright.files.ply import header
from gearwright.files.step import faces, reading, worker
from gearwright.files.text import decimals
from gearwright.files.three_mf import package

from .pages import ROOT, assert_blocks_print_what_stands_below, links

PAGE = ROOT / "docs/files.md"
TEXT = PAGE.read_text(encoding="utf-8")
COMMANDS = re.findall(r"^    (gearwright .*)$", TEXT, flags=re.MULTILINE)


def test_the_block_prints_what_stands_below_it_and_the_commands_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert_blocks_print_what_stands_below(PAGE, capsys)
    assert len(COMMANDS) == 5
    for command in COMMANDS:
        words, _, given = command.partition(" < ")
        if given:
            monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO((tmp_path / given).read_bytes())))
        assert main(shlex.split(words)[1:]) == 0, command
        outcome = capsys.readouterr()
        assert outcome.out or "wrote" in outcome.err


def test_every_format_has_a_row_with_its_suffixes_and_a_section():
    rows = dict(re.findall(r"^\| \[(\w+)[^]]*\]\(#\w+\) \| ([^|]*) \|", TEXT, flags=re.MULTILINE))
    bodies = [one for one in FILE_FORMATS if one.holds != "mechanism"]  # those have a page of their own
    assert rows == {one.name: ", ".join(f"`{suffix}`" for suffix in one.suffixes) for one in bodies}
    for anchor in re.findall(r"^\| \[\w+[^]]*\]\(#(\w+)\)", TEXT, flags=re.MULTILINE):
        assert re.search(rf"^## {anchor}$", TEXT, flags=re.MULTILINE | re.IGNORECASE)
    written = re.findall(r"^\| (\w+)[^|[]* \| (?:triangles|polygons) \|", TEXT, flags=re.MULTILINE)
    assert written == [one.name for one in FILE_FORMATS if one.writer and one.holds == "polygons"]


@pytest.mark.parametrize(
    "said",
    [
        f"at most {decimals.LONGEST_WORD} characters",
        f"{instances.MOST_DEPTH} nodes one inside another, {instances.MOST_NODES:,} placed ones",
        f"{instances.MOST_FACES // 10**6} million triangles",
        f"up to {streams.MOST_BYTES >> 30} GiB",
        f"{package.MOST_BYTES >> 30} GiB unpacked, and {package.MOST_RATIO} times the size of the file",
        f"within {faces.DEFLECTION:.0e}".replace("e-04", "e-4"),
        f"{worker.MOST_MEMORY >> 30} GiB where the system",
        f"{reading.LEAST_SECONDS:.0f} s + 1 s for every {reading.BYTES_A_SECOND // 1000} kB",
        f"Headers have at most {header.LONGEST >> 10} KiB",
    ],
)
def test_limits_are_those_of_the_code(said):
    assert said in " ".join(TEXT.split())


@pytest.mark.parametrize("file", links(PAGE), ids=lambda file: file.name)
def test_links_lead_somewhere(file):
    assert file.exists()
