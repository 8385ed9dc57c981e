"""Every reader of a file refuses what cannot be read to its end, with one sentence."""

import os
import re
import time

import pytest

from asperity.errors import InputError
from asperity.reading import (
    LARGEST_FILE,
    MOST_KEY_PARTS,
    MOST_LEVELS,
    open_text,
    parse_toml,
    read_bytes,
    read_json,
    read_text,
    read_toml,
)

READERS = [read_bytes, read_text, read_toml, read_json]


def opened(path):
    with open_text(path) as stream:
        return stream.read()


@pytest.mark.parametrize("reader", [*READERS, opened])
def test_only_regular_files_are_read(tmp_path, reader):
    os.mkfifo(tmp_path / "pipe")
    for path, reason in [
        (tmp_path / "absent", "there is no such file"),
        (tmp_path, "this is a directory"),
        (tmp_path / "pipe", "this is a pipe or a device, not a regular file"),
        ("/dev/zero", "this is a pipe or a device"),
        ("a\0b", "this is not a valid file name"),
        (tmp_path / ("x" * 300), "cannot be read: File name too long"),
    ]:
        with pytest.raises(InputError, match=reason):
            reader(path)


@pytest.mark.parametrize("reader", READERS)
def test_the_size_is_limited(tmp_path, reader):
    (tmp_path / "large").write_bytes(b" " * (LARGEST_FILE + 1))
    with pytest.raises(InputError, match="large: this file has 1000001 bytes; at most 1000000 bytes"):
        reader(tmp_path / "large")
    (tmp_path / "small").write_bytes(b"{}  ")
    with pytest.raises(InputError, match="at most 3 bytes"):
        reader(tmp_path / "small", largest=3)


def test_files_of_the_system_without_a_size_are_limited_too():
    if not os.path.exists("/proc/self/maps"):
        pytest.skip("no /proc here")
    with pytest.raises(InputError, match="at most 10 bytes"):
        read_bytes("/proc/self/maps", largest=10)


@pytest.mark.parametrize("reader", [*READERS[1:], opened])
def test_only_utf_8_is_read(tmp_path, reader):
    (tmp_path / "latin").write_bytes(b'a = "\xb5"')
    with pytest.raises(InputError, match="latin: this is not a text file in UTF-8"):
        reader(tmp_path / "latin")


def test_a_byte_order_mark_and_line_ends(tmp_path):
    (tmp_path / "a").write_bytes(b"\xef\xbb\xbfa = 1\r\nb = 2\r\n")
    assert read_text(tmp_path / "a") == opened(tmp_path / "a") == "a = 1\r\nb = 2\r\n"
    assert read_toml(tmp_path / "a") == {"a": 1, "b": 2}


@pytest.mark.parametrize("levels", [MOST_LEVELS + 1, 300, 2000, 100_000])
def test_deep_nesting_is_refused(tmp_path, levels):
    (tmp_path / "deep.json").write_text("[" * levels + "]" * levels)
    (tmp_path / "deep.toml").write_text("a = " + "[" * levels + "]" * levels)
    for reader, name in ((read_json, "deep.json"), (read_toml, "deep.toml")):
        with pytest.raises(InputError, match=rf"{name}: nested too deeply; at most {MOST_LEVELS} levels"):
            reader(tmp_path / name)


def test_the_deepest_nesting_is_read(tmp_path):
    (tmp_path / "a.json").write_text("[" * MOST_LEVELS + "]" * MOST_LEVELS)
    assert str(read_json(tmp_path / "a.json")).count("[") == MOST_LEVELS
    (tmp_path / "b.json").write_text("5")
    assert read_json(tmp_path / "b.json") == 5


@pytest.mark.parametrize("form", ["{} = 1", "[{}]", "a = {{ {} = 1 }}", "{} = 1 # 'a'", "\n\n  [[ {} ]]"])
@pytest.mark.parametrize("dot", [".", " . ", "\t."])
def test_a_long_dotted_key_is_refused_before_it_is_parsed(form, dot):
    for part in ("a", '"b c"', "'.'", '"\\""'):
        key = dot.join([part] * 20_000)
        start = time.perf_counter()
        with pytest.raises(InputError, match=rf"line [13]: a key has at most {MOST_KEY_PARTS} parts"):
            parse_toml(form.format(key), source="x")
        assert time.perf_counter() - start < 1.0
    shortest_refused = dot.join(f"k{i}" for i in range(MOST_KEY_PARTS + 1))
    with pytest.raises(InputError, match="at most 16 parts"):
        parse_toml(f"{shortest_refused} = 1", source="x")
    assert parse_toml(f"{shortest_refused.rpartition(dot)[0]} = 1", source="x")


@pytest.mark.parametrize(
    ("name", "text", "reason"),
    [
        ("a.toml", "a = ", "not valid TOML: Invalid value"),
        (
            "a.toml",
            'b = 1\n[c]\nsun = "9 mm"\nsun = "10 mm" # now\n',
            "not valid TOML: line 4 states a key for the second time: 'sun = \"10 mm\" # now'; remove one of both",
        ),
        (
            "a.toml",
            "[c]\na = 1\n[d]\n[c]\n",
            "not valid TOML: line 4 begins a section for the second time: '[c]'; make one of both",
        ),
        ("a.toml", "a = 1\nb = x\n", "Invalid value (at line 2, column 5): 'b = x'"),
        ("a.toml", "a = " + "9" * 5000, "not valid TOML: a number has too many digits"),
        ("a.json", "{", "not valid JSON: Expecting property name"),
        ("a.json", "9" * 5000, "not valid JSON: a number has too many digits"),
        ("a.toml", f"a = [1, {10**309}]", "a whole number has too many digits; at most 308 are read"),
        (
            "a.json",
            f'{{"a": {{"b": -{10**309}}}}}',
            "a whole number has too many digits; at most 308 are read",
        ),
    ],
)
def test_what_is_neither_toml_nor_json(tmp_path, name, text, reason):
    (tmp_path / name).write_text(text)
    with pytest.raises(InputError, match=re.escape(reason)):
        (read_toml if name.endswith("toml") else read_json)(tmp_path / name)


@pytest.mark.parametrize(
    "text",
    [
        "# " + "a" * 900_000,
        "# " + "a." * 450_000,
        'x = "' + "a." * 450_000 + '"',
        'x = """' + 'a."' * 300_000 + 'a"""',
        "x = '''" + "a.\n" * 300_000 + "'''",
        "\n" * 900_000,
        "a" + " " * 900_000 + "= 1",
    ],
    ids=["word", "dotted comment", "text", "long text", "raw text", "empty lines", "spaces"],
)
def test_a_long_word_is_read_in_no_time_and_only_keys_are_counted(text):
    start = time.perf_counter()
    parse_toml(text, source="x")
    assert time.perf_counter() - start < 3.0  # .1 to 1 s here; an hour where the time grows with the square


@pytest.mark.parametrize(
    "text",
    ["a" * 900_000, '"\\' * 450_000, '"""' + '\\"""' * 220_000, "'" * 900_000, ("a." * 15 + "a ") * 28_000],
)
def test_what_never_ends_is_refused_in_no_time(text):
    start = time.perf_counter()
    with pytest.raises(InputError, match="not valid TOML"):
        parse_toml(text, source="x")
    assert time.perf_counter() - start < 3.0


LONG = ".".join("abcdefghijklmnopq")


@pytest.mark.parametrize(
    "before",
    [
        "x = 'a\"b' # 'c\n",
        'x = "a\'b" # "c\n',
        'x = "\\"" \n',
        'x = """a"""""\n',
        "x = '''a'''''\n",
        'x = """\\""""\n',
        'x = [""""a"""", {',
        "x = {y = '''a'''', z = {",
        "'#' = 1\n",
        '"#" = 1\n',
    ],
)
def test_no_text_or_comment_hides_a_long_key(before):
    with pytest.raises(InputError, match="a key has at most 16 parts"):
        parse_toml(f"{before}{LONG} = 1", source="x")
    closed = "}]" if "[" in before else "}}" if "{" in before else ""
    assert "x" in parse_toml(f"{before}{LONG[:-4]} = 1{closed}", source="x") or before[1] == "#"
