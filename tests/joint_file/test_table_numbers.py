"""Tables apart from their numbers, and put together again."""

import itertools
import json

from asperity.joint_file.si_tables import numbers, table_structure, with_numbers

TABLES = {"load": {"preload": 1000.0, "closure": "elastic"}, "drive": {"sun_radius": 4e-3, "planets": 3.0}}


def test_numbers_stand_in_the_order_of_the_sorted_names():
    assert numbers(TABLES) == (3.0, 4e-3, 1000.0)
    assert numbers({}) == ()


def test_tables_come_back_with_other_numbers():
    assert with_numbers(TABLES, numbers(TABLES)) == TABLES
    changed = with_numbers(TABLES, (1.0, 2.0, [5.0, 6.0]))
    assert changed == {
        "load": {"preload": [5.0, 6.0], "closure": "elastic"},
        "drive": {"sun_radius": 2.0, "planets": 1.0},
    }
    assert TABLES["load"]["preload"] == 1000.0


def test_files_share_a_structure_if_only_numbers_differ():
    other = with_numbers(TABLES, itertools.count())
    assert table_structure(other) == table_structure(TABLES)
    assert json.loads(table_structure(TABLES))["load"] == {"closure": "elastic", "preload": 1.0}
    renamed = {**TABLES, "load": {**TABLES["load"], "closure": "constant_pin_force"}}
    assert table_structure(renamed) != table_structure(TABLES)
