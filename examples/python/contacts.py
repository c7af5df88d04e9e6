"""Which parts of an assembly touch, interfere or are apart."""
import strata_csg as st

shelf = st.box((0, 0, 0), (10, 4, 1))
book = st.box((1, 1, 1), (2, 3, 4))  # stands on the shelf
box = st.box((5, 1, 0.875), (7, 3, 3))  # was put an eighth too low
lamp = st.sphere(1, 24).translated((20, 0, 5))
names = ("shelf", "book", "box", "lamp")
for pair in st.contacts([shelf, book, box, lamp]):
    print(names[pair["a"]], "and", names[pair["b"]], pair["relation"])
overlap = shelf & box
assert overlap.volume == st.box((5, 1, 0.875), (7, 3, 1)).volume == 0.5
