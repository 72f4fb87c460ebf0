import jsonschema
import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, given, settings
from schemathesis.checks import not_a_server_error
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_schema_conformance,
    status_code_conformance,
)

from gearwright.server.openapi import document
from gearwright.server.operations import OPERATIONS

from .serving import running

CHECKS = [not_a_server_error, status_code_conformance, content_type_conformance, response_schema_conformance]


@pytest.fixture(scope="module")
def server():
    with running(rate=(1e9, 1e9)) as one:
        yield one


@pytest.fixture(scope="module")
def described(server):
    with server.client() as client:
        return client.get("/api/openapi.json").json()


def test_the_document_is_openapi_and_its_schemas_are_schemas(described):
    assert described["openapi"] == "3.1.0"
    for schema in described["components"]["schemas"].values():
        jsonschema.Draft202012Validator.check_schema(schema)


def test_every_operation_has_its_route_and_no_other_is_described(server, described):
    paths = {(path, method.upper()) for path, one in described["paths"].items() for method in one}
    assert paths == {(one.path, one.method) for one in OPERATIONS}
    with server.client() as client:
        for path, method in paths:
            answer = client.request(method, path.replace("{id}", "0" * 32))
            assert str(answer.status_code) in described["paths"][path][method.lower()]["responses"]
            assert answer.status_code != 405


def test_bodies_that_are_refused_are_those_that_the_document_refuses():
    schemas = document({"type": "object"})["paths"]["/api/files"]["post"]["requestBody"]["content"]
    schema = schemas["application/json"]["schema"]
    assert schema["required"] == ["design", "suffix", "what"]
    assert schema["properties"]["step_schema"]["enum"] == ["AP214", "AP242", None]
    assert schema["additionalProperties"] is False


@pytest.mark.parametrize("operation", OPERATIONS, ids=lambda one: one.name)
def test_nothing_that_is_asked_is_a_fault_and_answers_are_as_described(server, described, operation):
    schema = schemathesis.openapi.from_dict(described)
    found = schema[operation.path][operation.method]

    @given(case=found.as_strategy())
    @settings(
        max_examples=8, deadline=None, database=None, phases=[Phase.generate], suppress_health_check=list(HealthCheck)
    )
    def asked(case):
        case.call_and_validate(base_url=server.url, checks=CHECKS, timeout=60)

    asked()
