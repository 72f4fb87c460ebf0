"""What each operation of the HTTP interface does."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, final

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import FileResponse, Response

from .. import __version__
from ..designs.kinds import commands
from ..designs.uploaded import UPLOADED
from ..materials import MATERIALS
from ..parameters import did_you_mean
from .bodies import BUILD, FILES, PLOTS, READ, TEXTS, Field, body_problems
from .files import FileJob, Files
from .job import Job, Rank
from .job_names import JobNames, admitted
from .leaving import while_there
from .openapi import document
from .outcomes import JobRefusedError
from .plain_json import NoJsonError, parsed
from .pool import Pool
from .reading import JSON_BYTES, body
from .refusals import told
from .replies import refusal, reply
from .uploads import MOST_BYTES_EACH, Uploads, plain_name

_SECONDS = {"quick": 20.0, "plot": 60.0, "build": 60.0, "known": 120.0}
_MEDIA = {
    ".zip": "application/zip",
    ".pdf": "application/pdf",
    ".svg": "image/svg+xml",
    ".stl": "model/stl",
    ".3mf": "model/3mf",
    ".obj": "model/obj",
    ".step": "model/step",
    ".stp": "model/step",
    ".gltf": "model/gltf+json",
    ".glb": "model/gltf-binary",
}


@final
class Api:
    """Handlers, by the names in OPERATIONS. quick, heavy   the pools for what is short, and for files"""

    def __init__(self, quick: Pool, heavy: Pool, files: Files, uploads: Uploads, names: JobNames):
        self.connections: Callable[[], int] = int
        self._quick, self._heavy, self._files, self._uploads, self._names = quick, heavy, files, uploads, names
        self._known: dict[str, asyncio.Task[dict[str, Any]]] = {}

    async def health(self, request: Request) -> Response:
        del request
        workers = {"quick": asdict(self._quick.numbers), "heavy": asdict(self._heavy.numbers)}
        told = {"status": "ok", "version": __version__, "workers": workers, "connections": self.connections()}
        return reply(told)

    async def openapi(self, request: Request) -> Response:
        del request
        return reply(document(await self._fact(self._names.schema, {"element": None})))

    async def elements(self, request: Request) -> Response:
        del request
        return reply(await self._fact(self._names.elements, {}))

    async def materials(self, request: Request) -> Response:
        del request
        return reply([{"name": one.name, "density": one.density} for one in MATERIALS])

    async def schema(self, request: Request) -> Response:
        element = request.query_params.get("element")
        known = commands()
        if element is not None and element not in known:
            words = f"choose one of {', '.join(known)}{did_you_mean(element, known)}"
            return refusal(400, "There is no such element", [told(words, "element")])
        return reply(await self._fact(self._names.schema, {"element": element}))

    async def read(self, request: Request) -> Response:
        return reply(await self._one(request, self._names.read, await _fields(request, READ), "quick"))

    async def texts(self, request: Request) -> Response:
        return reply(await self._of_design(request, self._names.texts, await _fields(request, TEXTS), "quick"))

    async def build(self, request: Request) -> Response:
        return reply(await self._of_design(request, self._names.build, await _fields(request, BUILD), "build"))

    async def plots(self, request: Request) -> Response:
        return reply(await self._of_design(request, self._names.plot, await _fields(request, PLOTS), "plot"))

    async def begin_file(self, request: Request) -> Response:
        source, wrapped = admitted(self._names.file, await _fields(request, FILES), self._uploads.folder)
        name = self._files.begin(source, wrapped).id
        url = f"/api/files/{name}"
        return reply({"id": name, "url": url}, 202, {"location": url})

    async def file(self, request: Request) -> Response:
        return reply(self._named(request).told())

    async def content(self, request: Request) -> Response:
        file = self._named(request)
        if file.path is None:
            raise HTTPException(409, f"This file is not there: it is {file.state}.")
        media = _MEDIA.get(Path(file.name).suffix, "application/octet-stream")
        headers = {"cache-control": "no-store"}
        return FileResponse(file.path, filename=file.name, media_type=media, headers=headers)

    async def drop_file(self, request: Request) -> Response:
        self._files.drop(self._named(request))
        return Response(status_code=204)

    async def upload(self, request: Request) -> Response:
        given = request.query_params.get("name", "")
        name = plain_name(given)
        known = (await self._fact(self._names.suffixes, {}))["suffixes"]
        if not given or Path(name).suffix not in known:
            words = f"a file is needed whose name ends in {', '.join(known)}"
            return refusal(400, "This file cannot be taken", [told(words, f"name = {given[:100]!r}")])
        data = await body(request, MOST_BYTES_EACH)
        path = await asyncio.to_thread(self._uploads.keep, name, data)
        try:
            checked = {"path": str(path), "folder": str(self._uploads.folder)}
            await self._one(request, self._names.check_upload, checked, "plot")
        except BaseException:
            self._uploads.forget(path)
            raise
        return reply({"value": f"{UPLOADED}{path.parent.name}/{name}", "name": name, "bytes": len(data)}, 201)

    def _named(self, request: Request) -> FileJob:
        try:
            return self._files[request.path_params["id"]]
        except KeyError:
            raise HTTPException(
                404, "There is no such file; files are forgotten ten minutes after they are made."
            ) from None

    async def _of_design(self, request: Request, source: str, fields: dict[str, Any], limit: str) -> dict[str, Any]:
        return await self._one(request, *admitted(source, fields, self._uploads.folder), limit)

    async def _one(self, request: Request, source: str, asked: Mapping[str, Any], limit: str) -> dict[str, Any]:
        """The one dict that a job yields to the client of a request, while that is there. Raises JobError."""
        job = self._quick.submit(source, asked, seconds=_SECONDS[limit])
        async with while_there(request, job):
            return await _only(job)

    async def _fact(self, source: str, asked: Mapping[str, Any]) -> dict[str, Any]:
        """What a job always answers, found once, whoever asked first: no page begins without."""
        key = f"{source} {json.dumps(asked)}"
        task = self._known.get(key)
        if task is None or (task.done() and (task.cancelled() or task.exception() is not None)):
            job = self._quick.submit(source, asked, seconds=_SECONDS["known"], rank=Rank.SHOWN)
            task = self._known[key] = asyncio.ensure_future(_only(job))
        return await asyncio.shield(task)


async def _only(job: Job) -> dict[str, Any]:
    """The one dict that a job yields, besides stages. Raises JobError."""
    found: dict[str, Any] | None = None
    try:
        async for answer in job:
            if isinstance(answer, dict) and answer.get("answer") != "stage":
                found = answer
    finally:
        job.cancel()
    if found is None:
        raise JobRefusedError("Nothing was answered.")
    return found


async def _fields(request: Request, fields: Mapping[str, Field]) -> dict[str, Any]:
    """The body of a request, of these fields. Raises HTTPException; JobRefusedError for one that is not so."""
    try:
        value = parsed(await body(request, JSON_BYTES))
    except NoJsonError as error:
        raise HTTPException(400, f"The request was not understood: {error}.") from None
    if problems := body_problems(fields, value):
        raise NotUnderstoodError("The request was not understood", problems)
    found: dict[str, Any] = value
    return found


class NotUnderstoodError(JobRefusedError):
    """A body that holds other fields than it should."""
