package org.hificamsim.presentation.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FloorPicturesTest {
  @TempDir Path folder;

  @Test
  void smallPictureStaysSame() throws IOException {
    draw(60, 40, "png", "plan.png");
    Setup.Floor picture = read("plan.png").get(0);
    assertTrue(picture.data().startsWith("data:image/png;base64,"));
    assertEquals(new Field(0, 30, 0, 20), picture.area());
    assertEquals(60, FloorPictures.image(picture).getWidth());
    draw(60, 40, "jpeg", "plan.jpg");
    assertTrue(read("plan.jpg").get(0).data().startsWith("data:image/jpeg;base64,"));
  }

  @Test
  void largePictureIsScaledDown() throws IOException {
    draw(9000, 300, "png", "plan.png");
    Setup.Floor picture = read("plan.png").get(0);
    assertEquals(2000, FloorPictures.image(picture).getWidth());
    assertEquals(67, FloorPictures.image(picture).getHeight(), 1);
    assertTrue(picture.data().length() < 1_400_000, picture.data().length() + " characters");
  }

  @ParameterizedTest
  @ValueSource(strings = {"none.png", "hall.xml", ".", "cut.png", "\u0000"})
  void reportsFileThatIsNoPictureInOneLine(String name) throws IOException {
    draw(60, 40, "png", "plan.png");
    byte[] whole = Files.readAllBytes(folder.resolve("plan.png"));
    Files.write(folder.resolve("cut.png"), java.util.Arrays.copyOf(whole, 60));
    Scenario scenario = scenario("FLOOR");
    Scenario named =
        scenario.withFloorplan(new Floorplan(name, scenario.floorplan().orElseThrow().area()));
    InputException refused =
        assertThrows(
            InputException.class, () -> FloorPictures.of(folder.resolve("hall.xml"), named));
    assertTrue(refused.getMessage().contains("hall.xml: floorplan is"), refused.getMessage());
    assertTrue(refused.getMessage().contains("expected a PNG or JPEG"), refused.getMessage());
    assertEquals(1, refused.getMessage().lines().count());
  }

  @Test
  void rejectsInvalidPictureInRecording() {
    Field field = new Field(0, 1, 0, 1);
    for (String data : List.of("", "data:image/png;base64,AAAA", "data:image/png;base64,?")) {
      assertThrows(
          InputException.class, () -> FloorPictures.image(new Setup.Floor(field, data)), data);
    }
  }

  private List<Setup.Floor> read(String name) throws IOException {
    return FloorPictures.of(folder.resolve("hall.xml"), scenario(name));
  }

  private Scenario scenario(String floor) throws IOException {
    Path hall =
        Path.of(System.getProperty("hificamsim.root", "."), "src/test/resources/seen/hall.xml");
    Path copy = folder.resolve("hall.xml");
    Files.writeString(copy, Files.readString(hall).replace("floor.png", floor));
    return ScenarioReader.read(copy, movement -> true, warning -> {});
  }

  /** Draws noise, which no format can compress. */
  private void draw(int width, int height, String type, String name) throws IOException {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Random random = new Random(1);
    for (int i = 0; i < width * height; i++) {
      image.setRGB(i % width, i / width, random.nextInt(1 << 24));
    }
    ImageIO.write(image, type, folder.resolve(name).toFile());
  }
}
