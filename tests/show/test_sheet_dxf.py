"""A sheet as DXF: entities in true size, layers, codes of special characters, the same text every time."""

import io
import sys

import pytest

from asperity.errors import MissingExtraError
from asperity.show.sheet import Circle, Line, Sheet, Text
from asperity.show.sheet_dxf import LAYERS, dxf_text, require_ezdxf, sheet_dxf

SHEET = Sheet(
    100.0, 50.0, 2.0, (50.0, 25.0),
    (Circle((1.0, 2.0), 5.0), Circle((0.0, 0.0), 3.0, "axis"), Line(((-5.0, 0.0), (5.0, 0.0)), arrows="both"),
     Text((0.0, 1.0), "⌀10 %%c", "center")),
)  # fmt: skip


def test_entities_have_true_sizes_and_layers():
    ezdxf = pytest.importorskip("ezdxf", reason="the extra 'report' is not installed")
    document = ezdxf.read(io.StringIO(sheet_dxf(SHEET)))
    assert not document.audit().has_errors
    assert document.units == ezdxf.units.MM
    circles = [(tuple(c.dxf.center)[:2], c.dxf.radius, c.dxf.layer) for c in document.query("CIRCLE")]
    assert circles == [((1.0, 2.0), 5.0, "OUTLINE"), ((0.0, 0.0), 3.0, "AXES")]
    (text,) = document.query("TEXT")
    assert (text.dxf.text, text.dxf.height) == ("%%c10 % %c", 1.25)  # 2.5 mm on paper at 2:1
    assert len(document.query("SOLID")) == 2
    assert {layer.dxf.name for layer in document.layers} >= {*LAYERS.values(), "TEXT"}
    assert document.layers.get("OUTLINE").dxf.lineweight == 50


def test_the_extents_and_the_first_view_are_those_of_the_paper():
    ezdxf = pytest.importorskip("ezdxf", reason="the extra 'report' is not installed")
    document = ezdxf.read(io.StringIO(sheet_dxf(SHEET)))
    # paper of 100 mm by 50 mm at 2:1, its middle at the origin
    assert tuple(document.header["$EXTMIN"])[:2] == (-25.0, -12.5)
    assert tuple(document.header["$EXTMAX"])[:2] == (25.0, 12.5)
    assert tuple(document.modelspace().dxf.extmin)[:2] == (-25.0, -12.5)
    (view,) = document.viewports.get("*Active")
    assert tuple(view.dxf.center)[:2] == (0.0, 0.0)
    assert view.dxf.height >= 25.0
    assert 50.0 <= view.dxf.height * view.dxf.aspect_ratio <= 55.0


def test_the_same_sheet_makes_the_same_text_and_leaves_the_options_of_ezdxf():
    ezdxf = pytest.importorskip("ezdxf", reason="the extra 'report' is not installed")
    before = ezdxf.options.write_fixed_meta_data_for_testing
    assert sheet_dxf(SHEET) == sheet_dxf(SHEET)
    assert ezdxf.options.write_fixed_meta_data_for_testing is before


def test_codes_of_a_text_are_undone():
    assert dxf_text("45° ± 1 %%%u ^J") == "45%%d %%p 1 % % %u ^ J"


def test_without_ezdxf_the_message_says_how_to_install_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(MissingExtraError, match=r"package 'ezdxf'.*pip install .*\[report\]"):
        require_ezdxf()
