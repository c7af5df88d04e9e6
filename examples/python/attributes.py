"""Colours, temperatures and materials that go through operations and files."""
import os
import tempfile

import numpy as np
import strata_csg as st

block = st.box((0, 0, 0), (4, 4, 2))
steel, paint = st.Material("steel", metallic=1), st.Material("paint", color=(0.8, 0, 0))
block = block.with_attributes(
    st.Attributes(
        vertex={"temperature": 20 + 5 * block.vertices[:, 2]},
        face={"material": np.zeros(12, int)},
        materials=[steel],
    )
)
part = st.difference([block, st.cylinder(1, 3, 64).translated((2, 2, -0.5))], cut_material=paint)
print(part)
drilled = part.source_operands == 1
material = part.attributes["material"]
assert {part.attributes.materials[number].name for number in material[drilled]} == {"paint"}
assert {part.attributes.materials[number].name for number in material[~drilled]} == {"steel"}

path = os.path.join(tempfile.mkdtemp(), "part.3mf")
print("lost:", st.write(path, part, unit="mm", attributes=part.attributes.only(["material"])))
mesh = st.read(path)
assert mesh.unit == "millimeter" and [m.name for m in mesh.attributes.materials] == ["steel", "paint"]
