package org.hificamsim.profiling.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MeasurementsFileTest {
  private static final PhotoCamera CAMERA = new PhotoCamera(0.02, 0.01, 200, 100);

  @TempDir Path folder;

  @Test
  void missingPipIsThatOfThePinholeCamera() throws IOException {
    List<Measurement> rows =
        read("image,q,d,z,confidence\na.jpg,0.5,10,0.05,0.8\nb.jpg,2,1,0.05,0.9\n");
    assertEquals(2, rows.size());
    assertEquals(0.0025 * 0.0025 / 0.0002, rows.get(0).pip(), 1e-12);
    assertEquals(Map.of("my-yolo", 0.8), rows.get(0).confidences());
    assertEquals("object", rows.get(0).object());
    assertEquals(1, rows.get(1).pip());
  }

  @Test
  void readsOptionalPipAndObjects() throws IOException {
    Measurement row = read("image;q;d;z;confidence;object;pip\na;0,5;10;0,05;1;car;0,2\n").get(0);
    assertEquals("car", row.object());
    assertEquals(0.2, row.pip());
  }

  @Test
  void reportsErrorsWithLineAndColumn() {
    String message =
        assertThrows(InputException.class, () -> read("image,q,d,z,confidence\na,1,1,0.05,80\n"))
            .getMessage();
    assertTrue(message.contains("my yolo.csv:2:12: confidence is '80', expected a"), message);
    message =
        assertThrows(InputException.class, () -> read("image,q,d,confidence\na,1,1,0.8\n"))
            .getMessage();
    assertTrue(message.contains("expected image,q,d,z,confidence among them"), message);
  }

  private List<Measurement> read(String table) throws IOException {
    Path file = folder.resolve("my yolo.csv");
    Files.writeString(file, table);
    return MeasurementsFile.readUserTable(file, CAMERA);
  }
}
