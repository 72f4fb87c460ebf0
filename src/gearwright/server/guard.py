"""Who may ask: hosts, origins, the token and how often, before anything else sees a request; headers of answers."""

from __future__ import annotations

from dataclasses import dataclass
from hmac import compare_digest
from typing import Any, final
from urllib.parse import parse_qsl, urlencode

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import RedirectResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from .buckets import Buckets
from .hosts import Names
from .replies import refusal

CSP = (
    "default-src 'self'; img-src 'self' data: blob:; connect-src 'self'; object-src 'none'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'"
)
HEADERS = {
    "content-security-policy": CSP,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), microphone=(), geolocation=(), usb=(), payment=()",
}
_SAFE = ("GET", "HEAD", "OPTIONS")
_MOST_COOKIES = 4
_POLICY = 1008  # of WebSocket's codes


@dataclass(frozen=True, kw_only=True)
class Refusal:
    """Why a request is not let in. headers   that the answer has besides"""

    status: int
    words: str
    headers: tuple[tuple[str, str], ...] = ()


@final
class Guard:
    """Around an application. token   that requests must hold, None where only this machine can send any"""

    def __init__(self, app: ASGIApp, names: Names, token: str | None, rates: Buckets):
        self._app, self._names, self._token, self._rates = app, names, token, rates

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        given = _token_in_query(scope)
        found = self._refusal(scope, headers, given)
        if scope["type"] == "websocket":
            await (_closed(found.words, receive, send) if found else self._app(scope, receive, send))
            return

        async def sending(message: Message) -> None:
            if message["type"] == "http.response.start":
                own = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    own[name] = value
            await send(message)

        if found is not None:
            answer: Any = refusal(found.status, found.words, headers=dict(found.headers))
        elif given is not None and self._token is not None and scope["method"] in _SAFE:
            answer = self._signed_in(scope, headers["host"])
        else:
            answer = self._app
        await answer(scope, receive, sending)

    def _refusal(self, scope: Scope, headers: Headers, given: str | None) -> Refusal | None:
        hosts = headers.getlist("host")
        if len(hosts) != 1 or not self._names.known(hosts[0]):
            told = f"This server is {self._names.shown}, and not {hosts[0][:100] if hosts else 'without a name'!r}"
            return Refusal(status=403, words=f"{told}; other names must be given to it by --host or --origin.")
        origins = headers.getlist("origin")
        if not all(self._names.own(origin, hosts[0]) for origin in origins):
            return Refusal(status=403, words=f"Pages of other origins ({origins[0][:100]}) may not use this server.")
        if headers.get("sec-fetch-site") == "cross-site" and not _follows_link(scope, headers):
            return Refusal(status=403, words="Pages of other sites may not use this server.")
        if not self._rates.take((scope.get("client") or ("", 0))[0]):
            return Refusal(
                status=429, words="Too many requests; try again in a second.", headers=(("Retry-After", "1"),)
            )
        if self._token is not None and not self._let_in(headers, given):
            words = "A token is needed: the address that `gearwright serve` printed holds it."
            return Refusal(status=401, words=words, headers=(("WWW-Authenticate", "Bearer"),))
        return None

    def _let_in(self, headers: Headers, given: str | None) -> bool:
        bearer = headers.get("authorization", "")
        held = [given or "", bearer[7:] if bearer[:7].lower() == "bearer " else "", *_cookies(headers, self._cookie)]
        return any([compare_digest(one.encode(), (self._token or "").encode()) for one in held])  # noqa: C419  none skipped

    @property
    def _cookie(self) -> str:
        return f"gearwright-{self._names.port}"  # cookies know no ports

    def _signed_in(self, scope: Scope, host: str) -> RedirectResponse:
        """Has the browser keep the token and leave it out of the address."""
        rest = urlencode([pair for pair in _query(scope) if pair[0] != "token"])
        path = "/" + scope["path"].lstrip("/\\")  # never another host's
        encrypted = (self._names.origin or "").startswith("https:") and self._names.is_outer(host)
        answer = RedirectResponse(path + (f"?{rest}" if rest else ""), status_code=303)
        answer.set_cookie(self._cookie, self._token or "", httponly=True, secure=encrypted, samesite="strict", path="/")
        return answer


def _follows_link(scope: Scope, headers: Headers) -> bool:
    """Whether a browser opens the page itself, for somebody who sees it."""
    opened = (headers.get("sec-fetch-mode"), headers.get("sec-fetch-dest")) == ("navigate", "document")
    return opened and scope["type"] == "http" and scope["method"] in _SAFE and scope["path"] == "/"


def _query(scope: Scope) -> list[tuple[str, str]]:
    try:
        return parse_qsl(scope["query_string"].decode("latin-1"), keep_blank_values=True, max_num_fields=100)
    except ValueError:
        return []


def _token_in_query(scope: Scope) -> str | None:
    return next((value for name, value in _query(scope) if name == "token"), None)


def _cookies(headers: Headers, name: str) -> list[str]:
    """The values of the first few cookies of a name, whatever other servers of this host have set beside them."""
    pairs = [one.partition("=") for line in headers.getlist("cookie") for one in line.split(";")]
    return [value.strip().strip('"') for own, _, value in pairs if own.strip() == name][:_MOST_COOKIES]


async def _closed(words: str, receive: Receive, send: Send) -> None:
    """Takes a WebSocket only to say why it is closed."""
    await receive()
    await send({"type": "websocket.accept"})
    await send({"type": "websocket.close", "code": _POLICY, "reason": words.encode()[:120].decode(errors="ignore")})
