"""Records that attributes of meshes list."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Material:
    """
    How a surface looks, as far as the materials of glTF, OBJ and 3MF agree.

    Parameters
    ----------
    name : str
    color : three or four numbers
        Red, green, blue as light, not as bytes of a screen, from 0 to 1; and opacity, 1 without.
    metallic, roughness : float
    image : int, optional
        A number in `Attributes.images`: multiplies the color, at the channel "texcoord".

    Raises
    ------
    ValueError
        For a color of another length, or a negative image.

    Examples
    --------
    >>> from strata_csg import Material
    >>> Material("paint", color=(0.8, 0, 0)).color
    (0.8, 0.0, 0.0, 1.0)
    """

    name: str = ""
    color: Sequence[float] = (1.0, 1.0, 1.0, 1.0)
    metallic: float = 0.0
    roughness: float = 1.0
    image: int | None = None

    def __post_init__(self) -> None:
        color = tuple(float(part) for part in self.color)
        if len(color) not in (3, 4):
            raise ValueError(f"material {self.name!r}: color: expected 3 or 4 numbers, found {len(color)}")
        object.__setattr__(self, "color", (*color, 1.0)[:4])
        object.__setattr__(self, "metallic", float(self.metallic))
        object.__setattr__(self, "roughness", float(self.roughness))
        if self.image is not None:
            object.__setattr__(self, "image", operator.index(self.image))
            if not 0 <= self.image < 2**32:
                raise ValueError(f"material {self.name!r}: image: there is no number {self.image}")


@dataclass(frozen=True)
class Image:
    """
    An encoded picture, as files hold it. Nothing looks into it.

    Parameters
    ----------
    name : str
        A file name without folders.
    media_type : str
        "image/png", "image/jpeg" and so on.
    data : bytes

    Examples
    --------
    >>> from strata_csg import Image
    >>> Image("wood.png", "image/png", b"...")
    Image(name='wood.png', media_type='image/png')
    """

    name: str
    media_type: str
    data: bytes = field(repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "data", bytes(memoryview(self.data)))
