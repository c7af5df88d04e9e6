"""The collection of meshes that STRATA_CORPUS names, with its INDEX.csv."""
import csv
import os
import pathlib
import sys


def meshes(script, most_triangles):
    """The folder and the names of all meshes in it, those that the index lists as duplicates or as larger left out. Ends
    the script where there is no collection."""
    corpus = os.environ.get("STRATA_CORPUS")
    if not corpus:
        sys.exit(f"{script}: skipped: STRATA_CORPUS does not name a collection")
    corpus = pathlib.Path(corpus)
    with open(corpus / "INDEX.csv", newline="") as index:
        return corpus, [row["path"] for row in csv.DictReader(index)
                        if not row["duplicate_of"] and int(row["nF"] or 0) <= most_triangles]
