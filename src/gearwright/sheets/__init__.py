"""Drawing sheets: views with dimensions, a title block and tables of data, as data and as DXF, SVG and PDF files."""

from .content import Content, Row, TitleBlock
from .layout import sheet
from .marks import Sheet
from .writing import WRITTEN, write

__all__ = ["WRITTEN", "Content", "Row", "Sheet", "TitleBlock", "sheet", "write"]
