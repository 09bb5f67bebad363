"""How far figures differ between the ensembles of a run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from .estimates import Estimate
from .tables import Table
from .texts import count_text, percent_text, range_text, titles_of, value_text

if TYPE_CHECKING:
    import pandas

__all__ = ["Ensembles"]


class Ensembles(NamedTuple):
    """How far the figures differ between the ensembles of a run with uncertain parameters: of each the value of all rocks,
    and the range in which most ensembles are. It contains the chance of their rocks. NaN: too few ensembles."""

    ensembles: int
    """Ensembles with rocks that were asked."""
    crossing: int
    """Of these, with rocks that cross or enter."""
    confidence: float
    """The share of the ensembles that is in the ranges."""
    share: Estimate
    """Of the rocks that cross or enter."""
    stopping_share: Estimate
    """Of the rocks that stop in a polygon."""
    energy_translational_kJ: Estimate
    energy_total_kJ: Estimate
    height_m: Estimate
    velocity_m_s: Estimate
    needs_energy_kJ: Estimate
    """Of the fence that the check asks for at a line."""
    needs_height_m: Estimate
    needs_class: Estimate
    """Its energy class; without a standard it means nothing."""
    percentile: float
    """The design percentile of energies, height and velocity [%]."""

    @classmethod
    def _of(cls, given: dict[str, Any] | None, percentile: float) -> Ensembles | None:
        if given is None:
            return None

        def of(key: str, unit: float = 1) -> Estimate:
            return Estimate._of(given.get(key), unit)

        return cls(given["ensembles"], given["crossing"], given["confidence"], of("share"), of("stopping"),
                   of("ke_translational_J", 1000), of("ke_total_J", 1000), of("height_m"), of("velocity_m_s"),
                   of("needs_energy_J", 1000), of("needs_height_m"), of("needs_class"), percentile)

    def frame(self) -> pandas.DataFrame:
        """A row for each figure that is known, with its range."""
        import pandas

        return pandas.DataFrame([(name, *each) for name, each in self._known()], columns=["figure", "value", "low", "high"])

    def _known(self) -> list[tuple[str, Estimate]]:
        found = [(name, each) for name, each in zip(self._fields, self) if isinstance(each, Estimate)]
        return [(name, each) for name, each in found if each.value == each.value]

    def _range_of(self, figure: str) -> str:
        found = getattr(self, figure, None)
        if found is None:
            return ""
        return range_text(figure, found.low, found.high) if found.value == found.value else "too few ensembles"

    def _why(self) -> str:
        which = count_text(self.ensembles, "ensemble")
        if self.crossing < self.ensembles:
            which += f", {self.crossing} of them with rocks that get there"
        return (f"{percent_text(self.confidence)} of the run's {which}, each with its own parameters and its own rocks, "
                "whose chance is in it")

    def _shown(self) -> Table:
        is_area = self.stopping_share.value == self.stopping_share.value
        titles = titles_of(self.percentile, "the polygon" if is_area else "the line", is_area)
        return Table((type(self).__name__, "all rocks", "ensembles"),
                     [(titles[name], value_text(name, each.value), range_text(name, each.low, each.high))
                      for name, each in self._known()], [f"Ensembles: {self._why()}."])

    def __repr__(self) -> str:
        return self._shown().text

    def _repr_html_(self) -> str:
        return self._shown().html
