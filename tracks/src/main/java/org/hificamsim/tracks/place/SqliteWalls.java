package org.hificamsim.tracks.place;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.tracks.format.SqliteReader;
import org.hificamsim.tracks.place.DrawnPart.Traits;

/** Reads the areas that people walk in from the table {@code geometry} of JuPedSim's SQLite. */
record SqliteWalls(WktShapes shapes) {
  void read(Path file) {
    boolean isFound =
        SqliteReader.find(file)
            .read(
                file,
                "geometry",
                List.of("wkt"),
                row -> shapes.add(row.place(0), row.text(0), Traits.NONE));
    if (!isFound) {
      throw InputException.of("%s: expected the table geometry of JuPedSim", file);
    }
  }
}
