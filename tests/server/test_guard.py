import asyncio

import httpx
import pytest

from gearwright.server.buckets import Bucket, Buckets
from gearwright.server.guard import CSP, Guard
from gearwright.server.hosts import Names, is_loopback, is_name, origin_of

ALL = "0.0.0.0"  # noqa: S104
TOKEN = "a-long-token-of-letters"  # noqa: S105


async def echo(scope, receive, send):
    """Answers with the path and the query that came through."""
    await send({"type": "http.response.start", "status": 200, "headers": [(b"content-type", b"text/plain")]})
    text = scope["path"].encode() + b"?" + scope["query_string"]
    await send({"type": "http.response.body", "body": text})


def asked(
    method="GET", path="/", *, host="127.0.0.1", port=8321, outer=None, token=None, rates=None, header=None, **headers
):
    """The answer of a guard for a server at host and port."""
    guard = Guard(echo, Names(host=host, port=port, origin=outer), token, rates or Buckets(1e9, 1e9))

    async def doing():
        transport = httpx.ASGITransport(guard)
        async with httpx.AsyncClient(transport=transport, base_url=f"http://127.0.0.1:{port}") as client:
            named = {name.replace("_", "-"): value for name, value in headers.items()}
            return await client.request(method, path, headers={"Host": header or f"127.0.0.1:{port}", **named})

    return asyncio.run(doing())


@pytest.mark.parametrize("header", ["127.0.0.1:8321", "localhost:8321", "LOCALHOST:8321", "[::1]:8321"])
def test_this_machines_names_are_let_in(header):
    assert asked(header=header).status_code == 200


@pytest.mark.parametrize(
    "header",
    [
        "evil.example:8321",
        "127.0.0.1.evil.example:8321",
        "localhost.evil.example:8321",
        "127.0.0.1:8322",
        "127.0.0.1",
        "192.168.1.7:8321",
        "evil@127.0.0.1:8321",
        "",
        "[::1]",
    ],
)
def test_other_names_are_refused_whoever_they_lead_here(header):
    answer = asked(header=header) if header else asked(header=" ")
    assert answer.status_code == 403
    assert "--host" in answer.json()["headline"]


@pytest.mark.parametrize(
    ("host", "header", "status"),
    [
        ("gears.local", "gears.local:8321", 200),
        ("gears.local", "192.168.1.7:8321", 403),
        (ALL, "192.168.1.7:8321", 200),  # an address is no name that another page could point here
        (ALL, "evil.example:8321", 403),
        ("::", "[fe80::1]:8321", 200),
    ],
)
def test_the_name_that_it_is_bound_to_is_its_own(host, header, status):
    assert asked(host=host, header=header, token=TOKEN, authorization=f"Bearer {TOKEN}").status_code == status


@pytest.mark.parametrize(
    ("method", "origin", "status"),
    [
        ("POST", "http://127.0.0.1:8321", 200),
        ("POST", "http://evil.example", 403),
        ("DELETE", "http://localhost:8321", 403),  # another origin than the Host header's
        ("POST", "http://127.0.0.1:8322", 403),
        ("POST", "https://127.0.0.1:8321", 403),
        ("POST", "null", 403),
        ("PUT", "http://127.0.0.1:8321.evil.example", 403),
        ("GET", "http://evil.example", 403),
        ("GET", "http://127.0.0.1:8321", 200),
    ],
)
def test_pages_of_other_origins_neither_change_nor_read_anything(method, origin, status):
    assert asked(method, origin=origin).status_code == status


@pytest.mark.parametrize(
    ("outer", "header", "origin", "status"),
    [
        ("https://gear.example", "gear.example", "https://gear.example", 200),
        ("https://gear.example", "Gear.example:443", "https://gear.example", 200),
        ("https://gear.example", "127.0.0.1:8321", "https://gear.example", 200),  # the proxy set its own Host
        ("https://gear.example", "127.0.0.1:8321", "http://127.0.0.1:8321", 200),
        ("https://gear.example:8443", "gear.example:8443", "https://gear.example:8443", 200),
        ("https://gear.example", "gear.example", "http://gear.example", 403),  # anyone between could be that one
        ("https://gear.example", "gear.example:8443", "https://gear.example", 403),
        ("https://gear.example", "gear.example:80", "https://gear.example", 403),
        ("https://gear.example:8443", "gear.example", "https://gear.example:8443", 403),
        ("https://gear.example", "evil.example", "https://gear.example", 403),
        ("https://gear.example", "gear.example", "https://evil.example", 403),
        ("https://gear.example", "gear.example", "https://gear.example.evil.example", 403),
        (None, "gear.example", "https://gear.example", 403),
    ],
)
def test_a_proxy_s_origin_is_this_server_s_own(outer, header, origin, status):
    assert asked("POST", outer=outer, header=header, origin=origin).status_code == status


def test_the_cookie_of_an_encrypted_origin_stays_with_it():
    way = f"/?token={TOKEN}"
    outer = asked("GET", way, outer="https://gear.example", header="gear.example", token=TOKEN)
    assert "Secure" in outer.headers["set-cookie"]
    assert "Secure" not in asked("GET", way, outer="https://gear.example", token=TOKEN).headers["set-cookie"]
    assert "Secure" not in asked("GET", way, token=TOKEN).headers["set-cookie"]


@pytest.mark.parametrize(
    ("address", "found"),
    [
        ("https://Gear.example/", "https://gear.example"),
        ("https://gear.example:443", "https://gear.example"),
        ("http://gear.example:443", "http://gear.example:443"),
        ("http://[fe80::1]:80", "http://[fe80::1]"),
        ("gear.example", None),
        ("https://gear.example/gears", None),
        ("https://u:p@gear.example", None),
        ("ftp://gear.example", None),
        ("https://", None),
        ("", None),
        ("null", None),
    ],
)
def test_origins_are_told_from_other_addresses(address, found):
    assert origin_of(address) == found


LINK = {"sec_fetch_mode": "navigate", "sec_fetch_dest": "document"}


@pytest.mark.parametrize(
    ("method", "path", "headers", "status"),
    [
        ("GET", "/api/health", {"sec_fetch_mode": "no-cors", "sec_fetch_dest": "image"}, 403),
        ("GET", "/", {"sec_fetch_mode": "no-cors", "sec_fetch_dest": "image"}, 403),
        ("GET", "/", {"sec_fetch_mode": "navigate", "sec_fetch_dest": "iframe"}, 403),
        ("GET", "/api/health", LINK, 403),
        ("POST", "/", LINK, 403),
        ("GET", "/", LINK, 200),
    ],
)
def test_other_sites_may_only_link_to_the_page_and_use_up_nothing(method, path, headers, status):
    rates = Buckets(1.0, 1.0, clock=lambda: 0.0)
    for _ in range(3 if status == 403 else 1):
        assert asked(method, path, rates=rates, sec_fetch_site="cross-site", **headers).status_code == status
    own = asked(rates=rates, sec_fetch_site="same-origin", sec_fetch_mode="cors", sec_fetch_dest="empty")
    assert own.status_code == (200 if status == 403 else 429)


def test_a_token_is_needed_where_there_is_one():
    assert asked(token=TOKEN).status_code == 401
    assert asked(token=TOKEN).headers["www-authenticate"] == "Bearer"
    assert asked(token=TOKEN, authorization=f"Bearer {TOKEN}").status_code == 200
    for wrong in ("", TOKEN[:-1], TOKEN + "x", "ä"):
        assert asked(token=TOKEN, authorization=f"Bearer {wrong}".encode()).status_code == 401
        assert asked("GET", f"/?token={wrong}", token=TOKEN).status_code == 401
        assert asked(token=TOKEN, cookie=f"gearwright-8321={wrong}".encode()).status_code == 401


def test_a_token_in_the_address_becomes_a_cookie_that_scripts_and_other_sites_cannot_use():
    answer = asked("GET", f"/api/x?a=1&token={TOKEN}&b=2", token=TOKEN)
    assert (answer.status_code, answer.headers["location"]) == (303, "/api/x?a=1&b=2")
    cookie = answer.headers["set-cookie"]
    assert {"HttpOnly", "SameSite=strict", "Path=/"} <= {part.strip() for part in cookie.split(";")}
    assert asked(token=TOKEN, cookie=cookie.split(";")[0]).text == "/?"


@pytest.mark.parametrize(
    "cookies",
    [
        '{own}; other="a b',
        "other={{}}; {own}",
        "a[0]=1;{own}; =; x",
        "näme=ü; {own}",
        "gearwright-8321=older; {own}",
        'expires=Mon, 1 Jan; {own}; path="/"',
    ],
)
def test_cookies_of_other_servers_on_the_host_are_in_nobodys_way(cookies):
    own = f"gearwright-8321={TOKEN}"
    assert asked(token=TOKEN, cookie=cookies.format(own=own).encode()).status_code == 200
    assert asked(token=TOKEN, cookie=cookies.format(own=f"x{own}").encode()).status_code == 401


def test_the_way_on_from_a_token_never_leaves_this_server():
    answer = asked("GET", f"//evil.example/?token={TOKEN}", token=TOKEN)
    assert answer.headers["location"].startswith("/")
    assert not answer.headers["location"].startswith("//")


def test_every_answer_has_the_headers_that_bind_browsers():
    for answer in (asked(), asked(header="evil.example:8321"), asked(token=TOKEN)):
        assert answer.headers["content-security-policy"] == CSP
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert answer.headers["referrer-policy"] == "no-referrer"
        assert answer.headers["cross-origin-opener-policy"] == "same-origin"
        assert answer.headers["cross-origin-resource-policy"] == "same-origin"
        assert "permissions-policy" in answer.headers
        assert "server" not in answer.headers
    assert not [word for word in ("unsafe", "http", "*") if word in CSP]


def test_too_many_requests_are_put_off():
    rates = Buckets(1.0, 3.0, clock=lambda: 0.0)
    found = [asked(rates=rates) for _ in range(5)]
    assert [one.status_code for one in found] == [200, 200, 200, 429, 429]
    assert found[-1].headers["retry-after"] == "1"


def test_a_bucket_fills_at_its_rate_up_to_its_brim():
    now = 0.0
    bucket = Bucket(2.0, 4.0, clock=lambda: now)
    assert [bucket.take() for _ in range(5)] == [True] * 4 + [False]
    now = 1.0
    assert [bucket.take() for _ in range(3)] == [True, True, False]
    now = 1000.0
    assert [bucket.take() for _ in range(5)] == [True] * 4 + [False]


def test_one_address_does_not_use_up_anothers():
    buckets = Buckets(1.0, 1.0, clock=lambda: 0.0)
    assert [buckets.take(name) for name in ("a", "a", "b", "b")] == [True, False, True, False]


def test_names_and_loopback():
    assert all(map(is_loopback, ["127.0.0.1", "localhost", "::1", "127.8.0.1"]))
    assert not any(map(is_loopback, [ALL, "::", "192.168.1.7", "gears.local"]))
    assert all(map(is_name, ["127.0.0.1", "localhost", "::1", "a-b.c"]))
    assert not any(map(is_name, ["", "a b", "http://x", "-x", "x/y"]))
