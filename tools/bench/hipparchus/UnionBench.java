// Union of two meshes by Hipparchus: java UnionBench A.off B.off SECONDS_OF_WARM_UP RUNS TOLERANCE
// Prints one JSON object: seconds per run (trees built and merged), nodes, volume and area of the union.
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Scanner;
import org.hipparchus.geometry.euclidean.threed.Euclidean3D;
import org.hipparchus.geometry.euclidean.threed.PolyhedronsSet;
import org.hipparchus.geometry.euclidean.threed.Vector3D;
import org.hipparchus.geometry.partitioning.BSPTree;
import org.hipparchus.geometry.partitioning.Region;
import org.hipparchus.geometry.partitioning.RegionFactory;

public final class UnionBench {
  private final List<Vector3D> vertices = new ArrayList<>();
  private final List<int[]> facets = new ArrayList<>();

  private UnionBench(String file) throws Exception {
    Scanner words = new Scanner(Files.readString(Path.of(file)));
    words.next();
    int vertexCount = words.nextInt();
    int faceCount = words.nextInt();
    words.next();
    for (int i = 0; i < vertexCount; ++i) {
      vertices.add(new Vector3D(Double.parseDouble(words.next()), Double.parseDouble(words.next()),
                                Double.parseDouble(words.next())));
    }
    for (int i = 0; i < faceCount; ++i) {
      int[] face = new int[words.nextInt()];
      for (int k = 0; k < face.length; ++k) face[k] = words.nextInt();
      facets.add(face);
    }
  }

  private PolyhedronsSet region(double tolerance) { return new PolyhedronsSet(vertices, facets, tolerance); }

  private static int nodes(BSPTree<Euclidean3D> tree) {
    return tree.getCut() == null ? 0 : 1 + nodes(tree.getMinus()) + nodes(tree.getPlus());
  }

  public static void main(String[] arguments) throws Exception {
    UnionBench a = new UnionBench(arguments[0]);
    UnionBench b = new UnionBench(arguments[1]);
    double warmUp = Double.parseDouble(arguments[2]);
    int runs = Integer.parseInt(arguments[3]);
    double tolerance = Double.parseDouble(arguments[4]);
    RegionFactory<Euclidean3D> factory = new RegionFactory<>();
    StringBuilder seconds = new StringBuilder();
    Region<Euclidean3D> union = null;
    long start = System.nanoTime();
    for (int run = 0; run < runs;) {
      boolean isWarm = (System.nanoTime() - start) * 1e-9 >= warmUp;
      long begin = System.nanoTime();
      union = factory.union(a.region(tolerance), b.region(tolerance));
      if (!isWarm) continue;
      seconds.append(run++ == 0 ? "" : ", ").append((System.nanoTime() - begin) * 1e-9);
    }
    System.out.println("{\"seconds\": [" + seconds + "], \"nodes\": " + nodes(union.getTree(false)) + ", \"volume\": "
        + union.getSize() + ", \"area\": " + union.getBoundarySize() + "}");
  }
}
