import asyncio
from pathlib import Path

from gearwright.server.files import Files
from gearwright.server.job_names import admitted
from gearwright.server.pool import Pool


def test_the_oldest_made_files_are_forgotten_when_they_are_too_many_bytes(tmp_path):
    asyncio.run(_made(tmp_path))


async def _made(folder):
    pool = Pool(1, warm=None)
    pool.start()
    files = Files(folder, pool, most_bytes=1000)
    try:
        made = [await _one(files, size) for size in (400, 300, 300)]
        assert [_there(files, one) for one in made] == [True, True, True]
        made.append(await _one(files, 310))
        assert [_there(files, one) for one in made] == [False, True, True, True]
        made.append(await _one(files, 91))
        assert [_there(files, one) for one in made] == [False, False, True, True, True]
        made.append(await _one(files, 5000))
        assert [_there(files, one) for one in made] == [False] * 5 + [True]
        made.append(await _one(files, 10))
        assert [_there(files, one) for one in made[-2:]] == [False, True]
    finally:
        await files.close()
        await pool.close()
    assert list(folder.iterdir()) == []


async def _one(files, size):
    file = files.begin(*admitted("tests.server.work:write", {"design": {"bytes": size}}, Path("uploads")))
    async with asyncio.timeout(30):
        while not file.over:
            await asyncio.sleep(0.01)
    assert file.held == size, file.headline
    return file


def _there(files, file):
    """Whether it is told of and lies there: both or neither."""
    try:
        told = files[file.id] is file
    except KeyError:
        told = False
    assert file.path.exists() is told
    return told
