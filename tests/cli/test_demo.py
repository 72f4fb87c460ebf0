import re


def test_demo_shows_the_order_of_convergence_in_100_columns(run, tmp_path):
    outcome = run("demo", "-o", tmp_path)
    assert outcome.code == 0, outcome.err
    assert max(map(len, outcome.out.splitlines())) <= 100
    rows = [
        re.split(r"\s{2,}", line.strip())
        for line in outcome.out.splitlines()
        if " straight" in line or " spiral" in line
    ]
    assert len(rows) == 16
    for row in rows:
        order, in_step = map(float, row[-2:])
        assert 0.75 < order < 1.4
        assert abs(in_step - 2 * order) < 0.02
    exact = {}
    for row in rows:
        exact.setdefault((row[0], row[1]), []).append(row[3])
    assert all(len(set(values)) == 1 for values in exact.values()), "straight and spiral agree"
    for trace in ("straight", "spiral"):
        assert {path.name for path in (tmp_path / trace).iterdir()} == {"pinion.stl", "gear.stl", "pair.png"}
