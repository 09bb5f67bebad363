"""What results with a frame have."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pandas

__all__: list[str] = []


class Framed:
    def frame(self) -> pandas.DataFrame:
        raise NotImplementedError

    def to_pandas(self) -> pandas.DataFrame:
        """As :meth:`frame`: its older name."""
        return self.frame()
