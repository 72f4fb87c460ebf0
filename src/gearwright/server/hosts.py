"""Names of this server: what a browser may call it, so that no other page can reach it by a name of its own."""

from __future__ import annotations

import ipaddress
import re
import socket
from contextlib import suppress
from dataclasses import dataclass

LOOPBACK = ("127.0.0.1", "localhost", "[::1]")
_ANY = ("0.0.0.0", "::")  # noqa: S104  compared with, not bound to
_LABEL = r"[A-Za-z0-9](?:[A-Za-z0-9-]{0,61}[A-Za-z0-9])?"
_NAME = re.compile(rf"(?=.{{1,253}}$){_LABEL}(?:\.{_LABEL})*|[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]+")
_ORIGIN = re.compile(r"(https?)://([A-Za-z0-9](?:[A-Za-z0-9.-]*[A-Za-z0-9])?|\[[0-9A-Fa-f:.]+\])(?::([0-9]{1,5}))?/?")
_PORTS = {"http": "80", "https": "443"}


def is_name(host: str) -> bool:
    """Whether this can be a host's name or address."""
    return _NAME.fullmatch(host) is not None


def origin_of(address: str) -> str | None:
    """An address of nothing but scheme, host and port as browsers write it in Origin headers; None for any other."""
    found = _ORIGIN.fullmatch(address)
    if found is None:
        return None
    scheme, host, port = found.groups()
    return f"{scheme}://{host.lower()}" + (f":{port}" if port not in (None, _PORTS[scheme]) else "")


def is_loopback(host: str) -> bool:
    """Whether only this machine can reach a server bound to this name."""
    if host == "localhost":
        return True
    address = _address(host)
    return address is not None and address.is_loopback


@dataclass(frozen=True, kw_only=True)
class Names:
    """The names that a Host header may hold, for a server bound to a host and a port.

    Bound to all addresses, it is known by any address, which no name server can make another page's, and by the
    machine's own name.

    origin   that browsers reach it by through a proxy, as `origin_of` gives it; None where there is none
    """

    host: str
    port: int
    origin: str | None = None

    def known(self, header: str) -> bool:
        """Whether a Host header is one of this server's."""
        if self.is_outer(header):
            return True
        name, _, port = header.rpartition(":") if re.search(r":\d+$", header) else (header, "", "80")
        if port != str(self.port):
            return False
        return name.lower() in self._names or (self.host in _ANY and _address(name.strip("[]")) is not None)

    def is_outer(self, header: str) -> bool:
        """Whether a Host header is that of the origin which a proxy has."""
        if self.origin is None:
            return False
        scheme, _, host = self.origin.partition("://")
        return header.lower() in (host, f"{host}:{_PORTS[scheme]}")

    def own(self, origin: str, header: str) -> bool:
        """Whether an Origin header is that of this server's page, beside a known Host header."""
        if self.origin is not None and origin.lower() == self.origin:
            return True
        return not self.is_outer(header) and origin.lower() == f"http://{header.lower()}"

    @property
    def _names(self) -> set[str]:
        own = f"[{self.host}]" if ":" in self.host else self.host.lower()
        named = {socket.gethostname().lower()} if self.host in _ANY else set()
        return {*LOOPBACK, own, *named}

    @property
    def shown(self) -> str:
        """The host and port as an address shows it."""
        host = "127.0.0.1" if self.host == "0.0.0.0" else "::1" if self.host == "::" else self.host  # noqa: S104
        return self._with_port(host)

    @property
    def elsewhere(self) -> list[str]:
        """The host and port as others may write them, where it is bound to all addresses: its name, its address."""
        if self.host not in _ANY:
            return []
        named = [socket.gethostname().lower(), _outward(socket.AF_INET6 if self.host == "::" else socket.AF_INET)]
        return [self._with_port(name) for name in named if name and not is_loopback(name) and is_name(name)]

    def _with_port(self, host: str) -> str:
        return f"[{host}]:{self.port}" if ":" in host else f"{host}:{self.port}"


def _outward(family: socket.AddressFamily) -> str | None:
    """This machine's address on the network that leads elsewhere, None where there is none; nothing is sent."""
    beyond = "2001:db8::1" if family == socket.AF_INET6 else "192.0.2.1"  # kept for documents: nobody's
    with suppress(OSError), socket.socket(family, socket.SOCK_DGRAM) as one:
        one.connect((beyond, 9))
        return str(one.getsockname()[0])
    return None


def _address(host: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        return ipaddress.ip_address(host)
    except ValueError:
        return None
