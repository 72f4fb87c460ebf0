import io
import json
import re
import socket
import tempfile
import time
import zipfile

import jsonschema
import numpy as np
import pytest

from gearwright import Model
from gearwright.elements.cylindrical.spur_gear import SpurGear
from gearwright.materials import MATERIALS

from .serving import running

PAIR = {"element": "spur", "teeth": [16, 40], "module": 3, "face_width": 20}
WHEEL = {"element": "spur", "teeth": 16, "module": 3, "face_width": 20}
SQUARE = "0,0\n10,0\n10,10\n0,10\n"


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("page")
    (folder / "index.html").write_text("<!doctype html><title>Grüße</title>", encoding="utf-8")
    (folder / "page.js").write_text("export {};")
    (folder / "page.css").write_text("a {}")
    (folder.parent / "secret.txt").write_text("secret")
    return folder


@pytest.fixture(scope="module")
def server(page):
    with running(page=page, rate=(1e9, 1e9)) as one:
        yield one


@pytest.fixture
def client(server):
    with server.client() as one:
        yield one


def refused(answer, status):
    assert answer.status_code == status
    assert set(answer.json()) == {"headline", "problems"}
    return answer.json()


def done(client, **request):
    """The last that is told of a file once it is over, and its content."""
    begun = client.post("/api/files", json=request)
    assert begun.status_code == 202, begun.text
    url = begun.json()["url"]
    ends = time.monotonic() + 60
    while (told := client.get(url).json())["state"] in ("waiting", "working"):
        assert time.monotonic() < ends
        time.sleep(0.02)
    return told, client.get(f"{url}/content")


def uploaded(client, text, name="square.csv"):
    answer = client.post("/api/uploads", params={"name": name}, content=text)
    assert answer.status_code == 201, answer.text
    return answer.json()["value"]


def test_the_page_comes_with_its_type_and_is_asked_for_again(client):
    for path, type_ in (("/", "text/html"), ("/page.js", "text/javascript"), ("/page.css", "text/css")):
        answer = client.get(path)
        assert answer.headers["content-type"] == f"{type_}; charset=utf-8"
        assert answer.headers["cache-control"] == "no-cache"
        again = client.get(path, headers={"If-None-Match": answer.headers["etag"]})
        assert (again.status_code, again.content) == (304, b"")
    assert client.get("/").text == "<!doctype html><title>Grüße</title>"
    assert client.head("/").headers["content-length"] == client.get("/").headers["content-length"]


@pytest.mark.parametrize("path", ["/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "//etc/passwd", "/page"])
def test_nothing_beside_the_page_is_served(server, path):
    with socket.create_connection(("127.0.0.1", server.port), timeout=30) as connection:
        request = f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nConnection: close\r\n\r\n"
        connection.sendall(request.encode())
        assert connection.recv(4096).startswith(b"HTTP/1.1 404")


def test_health_tells_workers_and_connections(server, client):
    with server.live():
        told = client.get("/api/health").json()
    assert told["status"] == "ok"
    assert told["workers"]["quick"]["busy"] == 0
    assert told["connections"] == 1


def test_elements_and_materials_are_the_catalogs(client):
    kinds = client.get("/api/elements").json()
    assert kinds["length_units"] == ["mm", "in"]
    assert "spur pair" in [kind["name"] for kind in kinds["kinds"]]
    assert client.get("/api/materials").json() == [{"name": m.name, "density": m.density} for m in MATERIALS]


def test_a_design_is_held_to_the_schema_of_its_element(client):
    schema = client.get("/api/schema", params={"element": "spur"}).json()
    jsonschema.validate(PAIR, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**PAIR, "module": -3}, schema)
    assert (
        "did you mean" in refused(client.get("/api/schema", params={"element": "spru"}), 400)["problems"][0]["message"]
    )


def test_what_is_built_has_the_elements_own_volume(client):
    document = client.post("/api/build", json={"design": WHEEL, "material": "steel"}).json()
    exact = SpurGear(teeth=16, module=3, face_width=20).properties(7850e-9)
    assert document["properties"]["mass"] == exact.mass
    assert document["properties"]["mass_unit"] == "kg"


def test_toml_is_read_with_gaps_for_members(client):
    toml = 'element = "spur"\nteeth = [16, 40]\nmodule = 3\nface_width = 20\nbore = [8.0, "none"]\n'
    design = client.post("/api/read", json={"toml": toml}).json()["design"]
    assert design == {**PAIR, "bore": [8.0, None]}
    problem = refused(client.post("/api/read", json={"toml": "a = 1\nb ="}), 422)["problems"][0]
    assert problem["subject"].startswith("line 2")
    assert problem["message"].startswith("this is no TOML")


def test_toml_beyond_what_designs_need_is_refused(client):
    toml = 'element = "spur"\nteeth = [16, 40]\nmodule = 3\nface_width = 20\n'
    for broken in ("9" * 5000, "0x" + "f" * 5000, "inf", "[" * 500 + "]" * 500):
        refused(client.post("/api/read", json={"toml": f"{toml}pressure_angle = {broken}"}), 422)


@pytest.mark.parametrize("value", ["inf", "-inf", "nan", "[[0, 1], [nan, 0]]", "{circle = inf}"])
def test_toml_of_numbers_beyond_range_is_refused(client, value):
    answer = refused(client.post("/api/read", json={"toml": f'element = "sweep"\nsection = {value}\nlength = 3'}), 422)
    assert [one["subject"].split(" = ")[0] for one in answer["problems"]] == ["section"]


def test_all_that_is_wrong_with_a_design_is_told_by_parameter(client):
    told = refused(client.post("/api/build", json={"design": {**PAIR, "module": -1, "face_width": 0}}), 422)
    assert {problem["parameter"] for problem in told["problems"]} == {"module", "face_width"}
    told = refused(client.post("/api/build", json={"design": PAIR, "density": -1, "material": None}), 422)
    assert [problem["subject"] for problem in told["problems"]] == ["density = -1 kg/m³"]


@pytest.mark.parametrize("body", ["", "[]", "{", '{"design": 3}', '{"design": {}, "x": 1}', "\xff", '{"design": NaN}'])
def test_what_is_not_understood_is_no_fault(client, body):
    refused(client.post("/api/build", content=body.encode("latin-1")), 400)


def test_a_plot_is_the_job_s_own(client):
    chart = client.post("/api/plots", json={"design": PAIR, "plot": "profile"}).json()
    assert chart["equal"]
    assert {"pinion", "gear"} <= {line["name"] for line in chart["lines"]}


def test_a_file_is_made_fetched_and_forgotten(client, tmp_path):
    begun = client.post("/api/files", json={"design": WHEEL, "what": "body", "suffix": ".stl"})
    url = begun.json()["url"]
    assert begun.headers["location"] == url
    while (told := client.get(url).json())["state"] in ("waiting", "working"):
        time.sleep(0.02)
    content = client.get(f"{url}/content")
    assert (told["state"], told["name"], told["bytes"]) == ("done", "spur-16.stl", len(content.content))
    assert content.headers["content-disposition"] == 'attachment; filename="spur-16.stl"'
    (tmp_path / "a.stl").write_bytes(content.content)
    polyhedron = Model.load(tmp_path / "a.stl").polyhedron
    exact = SpurGear(teeth=16, module=3, face_width=20).properties().volume
    assert polyhedron.properties().volume == pytest.approx(exact, rel=1e-3)
    assert client.delete(url).status_code == 204
    refused(client.get(url), 404)
    refused(client.get(f"{url}/content"), 404)
    refused(client.delete(url), 404)


@pytest.mark.parametrize(
    ("request_", "name", "start"),
    [
        ({"what": "body", "suffix": ".step", "step_schema": "AP242"}, "spur-16-40.step", b"ISO-10303-21"),
        ({"what": "drawing", "suffix": ".svg"}, "spur-16-40-section.svg", b"<"),
        ({"what": "sheet", "suffix": ".pdf", "paper": "A4"}, "spur-16-40-sheet.pdf", b"%PDF"),
        ({"what": "body", "suffix": ".3mf", "tolerance": 0.05}, "spur-16-40.3mf", b"PK"),
    ],
)
def test_each_kind_of_file_is_what_its_suffix_says(client, request_, name, start):
    told, content = done(client, design=PAIR, **request_)
    assert (told["state"], told["name"]) == ("done", name), told
    assert content.content.startswith(start)


@pytest.mark.parametrize(
    ("request_", "names"),
    [
        ({"suffix": ".stl", "separate": True}, {"pinion.stl", "gear.stl"}),
        ({"suffix": ".urdf", "material": "steel"}, {"spur-16-40.urdf"}),
    ],
)
def test_several_files_become_one_zip(client, request_, names):
    told, content = done(client, design=PAIR, what="body", **request_)
    assert told["name"] == f"spur-16-40-{request_['suffix'][1:]}.zip", told
    with zipfile.ZipFile(io.BytesIO(content.content)) as archive:
        assert names <= set(archive.namelist())
        assert len(archive.namelist()) >= 2


def test_members_apart_are_each_in_their_own_frame_unless_placed(client, tmp_path):
    middles = {}
    for placed in (False, True):
        _, content = done(client, design=PAIR, what="body", suffix=".stl", separate=True, placed=placed)
        with zipfile.ZipFile(io.BytesIO(content.content)) as archive:
            archive.extractall(tmp_path / str(placed))
        gear = Model.load(tmp_path / str(placed) / "gear.stl").polyhedron
        middles[placed] = float(np.hypot(*gear.properties().centroid[:2]))
    assert middles[False] == pytest.approx(0.0, abs=1e-3)
    assert middles[True] == pytest.approx(3 * 28, rel=1e-3)  # the distance of the axes


@pytest.mark.parametrize(
    ("request_", "subject"),
    [
        ({"what": "body", "suffix": ".exe"}, "suffix"),
        ({"what": "drawing", "suffix": ".stl"}, "suffix"),
        ({"what": "body", "suffix": ".urdf"}, "density"),
        ({"what": "body", "suffix": ".step", "clearance": 0.1}, "clearance"),
        ({"what": "body", "suffix": ".stl", "tolerance": 0}, "tolerance"),
        ({"what": "body", "suffix": ".stl", "step_schema": "AP242"}, "step_schema"),
        ({"what": "body", "suffix": ".stl", "material": "stele"}, "material"),
    ],
)
def test_files_that_cannot_be_are_refused_by_what_is_wrong(client, request_, subject):
    told, content = done(client, design=PAIR, **request_)
    assert told["state"] == "failed"
    assert [problem["subject"].split(" = ")[0] for problem in told["problems"]] == [subject]
    refused(content, 409)


def test_a_file_that_is_being_made_is_cancelled_with_its_worker(client):
    large = {
        "element": "bevel",
        "teeth": [16, 20],
        "module": 4,
        "face_width": 15,
        "trace": "logarithmic",
        "spiral_angle": 35,
    }
    begun = client.post("/api/files", json={"design": large, "what": "body", "suffix": ".stl", "tolerance": 1e-4})
    url = begun.json()["url"]  # of a file that takes many seconds
    while "writing" not in (told := client.get(url).json())["stage"]:
        assert told["state"] in ("waiting", "working"), told
        time.sleep(0.02)
    assert client.delete(url).status_code == 204
    assert client.get(url).json()["state"] == "cancelled"
    ends = time.monotonic() + 10
    while client.get("/api/health").json()["workers"]["heavy"]["busy"]:
        assert time.monotonic() < ends
        time.sleep(0.02)
    told, _ = done(client, design=WHEEL, what="body", suffix=".stl")
    assert told["state"] == "done", told


def test_an_upload_stands_for_a_file_in_designs(client):
    design = {"element": "sweep", "section": uploaded(client, SQUARE), "length": 5}
    answer = client.post("/api/build", json={"design": design})
    assert answer.json()["properties"]["volume"] == pytest.approx(500.0, rel=1e-12)
    assert answer.json()["parameters"]["section"] == "square.csv"
    assert tempfile.gettempdir() not in answer.text
    told, _ = done(client, design=design, what="body", suffix=".stl")
    assert told["name"] == "sweep.stl", told


def test_refusals_of_an_upload_say_nothing_of_the_servers_folders(client):
    value = uploaded(client, "0,0\n10,0\n10,10\n0,10\n\n20,0\n30,0\n30,10\n")
    told = refused(client.post("/api/build", json={"design": {"element": "sweep", "section": value, "length": 5}}), 422)
    assert tempfile.gettempdir() not in json.dumps(told)
    assert "square.csv holds 2 regions" in json.dumps(told)


@pytest.mark.parametrize(
    "name", ["/etc/passwd", "square.csv", "../a.csv", "upload:0/a.csv", "upload:" + "0" * 32 + "/a.csv"]
)
def test_files_of_the_server_cannot_be_named(client, name):
    for url, more in (
        ("/api/build", {}),
        ("/api/plots", {"plot": "profile"}),
        ("/api/texts", {}),
    ):
        body = {"design": {"element": "sweep", "section": name, "length": 5}, **more}
        told = refused(client.post(url, json=body), 422)
        assert [problem["parameter"] for problem in told["problems"]] == ["section"]
    body = {"design": {"element": "sweep", "section": {"circle": 3}, "path": name}}
    assert refused(client.post("/api/build", json=body), 422)["problems"][0]["parameter"] == "path"


def test_an_upload_cannot_be_left_by_its_name(client):
    value = uploaded(client, SQUARE)
    head = value.split("/")[0]
    for name in (f"{head}/../../secret.csv", f"{head}/..", f"{head}/.", f"{head}/", f"{head}/other.csv"):
        body = {"design": {"element": "sweep", "section": name, "length": 5}}
        refused(client.post("/api/build", json=body), 422)


@pytest.mark.parametrize(
    "name", ["../../x.csv", "/etc/cron.csv", "a\\b.csv", "ä ö.CSV", ".csv", "a" * 300 + ".csv", "a\0b.csv"]
)
def test_uploads_keep_a_plain_name(client, name):
    value = uploaded(client, SQUARE, name)
    assert re.fullmatch(r"upload:[0-9a-f]{32}/[\w .()+-]{1,104}", value)
    design = {"element": "sweep", "section": value, "length": 5}
    assert client.post("/api/build", json={"design": design}).status_code == 200


@pytest.mark.parametrize(
    ("name", "data", "status", "told"),
    [
        ("a.exe", b"MZ", 400, ".csv, .dxf, .svg"),
        ("", b"", 400, "name ends"),
        ("a.dxf", b"nothing", 422, "a.dxf: this is no DXF"),
        ("a.csv", b"1,2\nx", 422, "a.csv"),
        ("a.svg", b'<!DOCTYPE a [<!ENTITY b "c">]><svg/>', 422, "a.svg"),
    ],
)
def test_what_no_reader_takes_is_not_kept(client, name, data, status, told):
    answer = refused(client.post("/api/uploads", params={"name": name}, content=data), status)
    assert answer["headline"] == "This file cannot be taken"
    assert told in " ".join(f"{one['subject']}: {one['message']}" for one in answer["problems"])


def test_the_oldest_uploads_are_forgotten(tmp_path):
    from gearwright.server.uploads import Uploads

    uploads = Uploads(tmp_path, most_files=3, most_bytes=100)
    paths = [uploads.keep("a.csv", b"x" * 10) for _ in range(4)]
    assert [path.is_file() for path in paths] == [False, True, True, True]
    paths += [uploads.keep("a.csv", b"x" * 85)]
    assert [path.is_file() for path in paths] == [False, False, False, True, True]


@pytest.mark.parametrize("chunked", [False, True])
def test_a_body_of_a_gigabyte_is_refused_without_being_read(server, chunked):
    sent = 0
    with socket.create_connection(("127.0.0.1", server.port), timeout=30) as connection:
        length = "Transfer-Encoding: chunked" if chunked else f"Content-Length: {1 << 30}"
        head = f"POST /api/uploads?name=a.csv HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n{length}\r\n\r\n"
        connection.sendall(head.encode())
        chunk = b"%x\r\n" % (1 << 20) + bytes(1 << 20) + b"\r\n" if chunked else bytes(1 << 20)
        answer = b""
        try:
            for _ in range(1024):
                connection.sendall(chunk)
                sent += 1
        except OSError:
            pass
        try:
            answer = connection.recv(4096)
        except OSError:
            answer = b""
    assert sent < 100  # MiB
    assert answer == b"" or answer.startswith(b"HTTP/1.1 413")


@pytest.mark.parametrize(
    ("path", "size", "told"),
    [("/api/uploads?name=a.csv", 40_000_000, "at most 20 MB"), ("/api/build", 3 << 20, "at most 1 MiB")],
)
def test_a_client_that_sends_all_before_it_reads_gets_to_read_the_refusal(server, path, size, told):
    head = f"POST {path} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nContent-Length: {size}\r\n\r\n"
    with socket.create_connection(("127.0.0.1", server.port), timeout=30) as connection:
        connection.sendall(head.encode())
        connection.sendall(bytes(size))
        answer = connection.recv(1 << 16)
        while b"}" not in answer:
            answer += connection.recv(1 << 16)
    assert answer.startswith(b"HTTP/1.1 413")
    assert told in answer.decode()


def test_a_client_that_asks_before_it_sends_is_refused_at_once(server):
    lines = (f"Host: 127.0.0.1:{server.port}", "Content-Length: 40000000", "Expect: 100-continue", "", "")
    with socket.create_connection(("127.0.0.1", server.port), timeout=30) as connection:
        connection.sendall("\r\n".join(["POST /api/uploads?name=a.csv HTTP/1.1", *lines]).encode())
        assert connection.recv(1 << 16).startswith(b"HTTP/1.1 413")


def test_bodies_that_are_too_large_are_told(client):
    refused(client.post("/api/build", content=b" " * ((1 << 20) + 1)), 413)
    refused(client.post("/api/build", content=(b" " * (1 << 18) for _ in range(5))), 413)
    refused(client.post("/api/uploads", params={"name": "a.csv"}, content=b" " * 20_000_001), 413)


@pytest.mark.parametrize(
    ("method", "path", "allowed"),
    [
        ("DELETE", "/api/health", "GET, HEAD"),
        ("GET", "/api/build", "POST"),
        ("PUT", "/api/files/" + "0" * 32, "DELETE, GET, HEAD"),
        ("TRACE", "/api/materials", "GET, HEAD"),
        ("POST", "/", "GET, HEAD"),
    ],
)
def test_methods_that_a_path_has_not_are_told_those_it_has(client, method, path, allowed):
    answer = client.request(method, path)
    refused(answer, 405)
    assert ", ".join(sorted(answer.headers["allow"].split(", "))) == allowed


def test_head_is_get_without_its_body(client):
    answer = client.head("/api/materials")
    assert (answer.status_code, answer.content) == (200, b"")
    assert int(answer.headers["content-length"]) == len(client.get("/api/materials").content)


def test_what_is_kept_is_the_owners_and_goes_with_the_server(page, tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    with running(page=page) as server, server.client() as client:
        uploaded(client, SQUARE)
        (folder,) = tmp_path.glob("gearwright-*")
        assert folder.stat().st_mode & 0o077 == 0
        assert len(list((folder / "uploads").iterdir())) == 1
    assert not folder.exists()
