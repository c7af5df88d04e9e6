"""A block with a bore, cut in halves: all volumes are fractions."""
import strata_csg as st

block = st.box((0, 0, 0), (4, 4, 2))
part = block - st.cylinder(1, 2, 64).translated((2, 2, 0))
below, above = part.split(((0, 0, 1), 0.25))
assert below.volume + above.volume == part.volume  # exactly
print(len(part.triangles), "triangles, volume about", float(part.volume))
st.write("part.ply", part)
