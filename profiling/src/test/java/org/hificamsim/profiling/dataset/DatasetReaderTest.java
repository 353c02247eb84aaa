package org.hificamsim.profiling.dataset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DatasetReaderTest {
  private static final String HEADER =
      "image,object,size_m,distance_m,focal_length_m,patch_x,patch_y,patch_width,patch_height,mask";
  private static final String ROW = "images/a.jpg,ball,0.22,1,0.085,10,10,20,30,";

  @TempDir Path folder;

  @BeforeEach
  void writeFolder() throws IOException {
    Files.writeString(
        folder.resolve("camera.json"),
        "{\"sensorWidth\": 0.0224, \"sensorHeight\": 0.015, \"width\": 60, \"height\": 40}");
    Photos.write(folder.resolve("images/a.jpg"), 60, 40);
    Photos.write(folder.resolve("images/b.png"), 60, 40);
    Photos.write(folder.resolve("images/wide.png"), 80, 40);
    Photos.write(folder.resolve("masks/a.png"), 60, 40);
    Photos.write(folder.resolve("templates/ball.png"), 30, 30);
    byte[] whole = Files.readAllBytes(folder.resolve("images/a.jpg"));
    Files.write(folder.resolve("images/cut.jpg"), Arrays.copyOf(whole, whole.length / 2));
    Files.writeString(folder.resolve("images/text.jpg"), "no picture");
  }

  @Test
  void readsTheTable() throws IOException {
    LabelledPhoto sample = sample(ROW + "masks/a.png");
    assertEquals("ball", sample.object());
    assertEquals(0.22, sample.size());
    assertEquals(1, sample.distance());
    assertEquals(0.085, sample.focalLength());
    assertEquals(new Patch(10, 10, 20, 30), sample.patch());
    assertEquals(Optional.of(folder.resolve("masks/a.png")), sample.mask());
  }

  @Test
  void maskColumnMayBeMissing() throws IOException {
    table(HEADER.replace(",mask", ""), ROW.substring(0, ROW.length() - 1));
    assertEquals(List.of(), DatasetReader.read(folder).problems());
  }

  @Test
  void emptyFocalLengthIsTakenFromThePhoto() throws IOException {
    Photos.writeWithFocalLength(folder.resolve("images/exif.jpg"), 60, 40, 24);
    assertEquals(0.024, sample("images/exif.jpg,ball,0.22,1,,10,10,20,30,").focalLength(), 1e-12);
  }

  @Test
  void emptyPatchIsTakenFromCoco() throws IOException {
    Files.writeString(
        folder.resolve("coco.json"),
        """
        {"info": {"year": 2020},
         "images": [{"id": 7, "file_name": "images/a.jpg", "width": 60, "height": 40}],
         "categories": [{"id": 1, "name": "ball"}, {"id": 2, "name": "cat"}],
         "annotations": [
          {"id": 1, "image_id": 7, "category_id": 2, "bbox": [0, 0, 5, 5], "iscrowd": 0},
          {"id": 2, "image_id": 7, "category_id": 1, "bbox": [10.4, 9.6, 20, 30]}]}
        """);
    assertEquals(new Patch(10, 10, 20, 30), sample("images/a.jpg,ball,0.22,1,0.085,,,,,").patch());
  }

  @ParameterizedTest
  @CsvSource({"50, 0", "50000, 1"})
  void rejectsImpossibleFocalLengthInExif(int millimetres, int over) throws IOException {
    Photos.writeWithFocalLength(folder.resolve("images/exif.jpg"), 60, 40, millimetres, over);
    List<String> problems = problems("images/exif.jpg,ball,0.22,1,,10,10,20,30,");
    assertEquals(1, problems.size(), problems.toString());
    assertTrue(problems.get(0).contains("dataset.csv:2:29: focal_length_m is ''"), problems.get(0));
    assertTrue(problems.get(0).contains("which is no lens's"), problems.get(0));
  }

  @Test
  void roundedBoxStaysWithinThePicture() throws IOException {
    Files.writeString(
        folder.resolve("coco.json"),
        """
{"images": [{"id": 7, "file_name": "images/a.jpg"}], "categories": [],
 "annotations": [{"id": 1, "image_id": 7, "category_id": 2, "bbox": [10.5, 9.5, 49.5, 30.5]}]}
""");
    assertEquals(new Patch(11, 10, 49, 30), sample("images/a.jpg,ball,0.22,1,0.085,,,,,").patch());
  }

  @Test
  void readsTablesOfSpreadsheets() throws IOException {
    String row = "images/a.jpg;ball;0,22;1;0,085;10;10;20;30;";
    Files.writeString(
        folder.resolve("dataset.csv"), "\uFEFF" + HEADER.replace(',', ';') + "\r\n" + row + "\r\n");
    DatasetReader.Reading reading = DatasetReader.read(folder);
    assertEquals(List.of(), reading.problems());
    assertEquals(0.22, reading.dataset().orElseThrow().samples().get(0).size());
  }

  @Test
  void photosMayBePortraitOrLandscape() throws IOException {
    Photos.write(folder.resolve("images/upright.png"), 40, 60);
    assertEquals(
        new Patch(5, 25, 30, 35),
        sample("images/upright.png,ball,0.22,1,0.085,5,25,30,35,").patch());
    List<String> problems = problems("images/upright.png,ball,0.22,1,0.085,25,5,30,35,");
    assertTrue(problems.get(0).contains("within the image's 40 x 60 pixels"), problems.get(0));
    problems = problems("images/upright.png,ball,0.22,1,0.085,5,25,30,35,masks/a.png");
    assertTrue(problems.get(0).contains("as wide and high as its image"), problems.get(0));
  }

  @Test
  void readsRotatedPhotoAsDisplayed() throws IOException {
    Photos.writeTurned(folder.resolve("images/turned.jpg"), 60, 40);
    assertEquals(
        new Patch(5, 25, 30, 35),
        sample("images/turned.jpg,ball,0.22,1,0.085,5,25,30,35,").patch());
  }

  @Test
  void otherColumnsAreIgnored() throws IOException {
    table(HEADER + ",aperture,distortion,light", ROW + ",f/8,,");
    assertEquals(1, DatasetReader.read(folder).dataset().orElseThrow().samples().size());
  }

  @Test
  void readsNegativesAndRejectsOtherSizes() throws IOException {
    Photos.write(folder.resolve("negatives/b.png"), 40, 60);
    Photos.write(folder.resolve("negatives/a.jpg"), 60, 40);
    Files.writeString(folder.resolve("negatives/notes.txt"), "not a photo");
    table(HEADER, ROW);
    Dataset dataset = DatasetReader.read(folder).dataset().orElseThrow();
    assertEquals(
        List.of(folder.resolve("negatives/a.jpg"), folder.resolve("negatives/b.png")),
        dataset.negatives());
    Photos.write(folder.resolve("negatives/c.png"), 50, 50);
    String problem = DatasetReader.read(folder).problems().get(0);
    assertTrue(problem.contains("c.png: is 50 x 50 pixels, expected 60 x 40"), problem);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "images/none.jpg,ball,0.22,1,0.085,10,10,20,30, | 2:1: image is 'images/none.jpg'",
        "images/text.jpg,ball,0.22,1,0.085,10,10,20,30, | (no PNG or JPEG)",
        "images/cut.jpg,ball,0.22,1,0.085,10,10,20,30, | cut short",
        "images/wide.png,ball,0.22,1,0.085,10,10,20,30, | 60 x 40 pixels as camera.json says, or"
            + " upright, not 80",
        "../a.jpg,ball,0.22,1,0.085,10,10,20,30, | expected the name of a picture in the folder",
        "images/a.jpg,,0.22,1,0.085,10,10,20,30, | object is ''",
        "images/a.jpg,cat,0.22,1,0.085,10,10,20,30, | templates/cat.png",
        "images/a.jpg,ball,0,1,0.085,10,10,20,30, | size_m is '0', expected metres above 0",
        "images/a.jpg,ball,-1,1,0.085,10,10,20,30, | size_m is '-1'",
        "images/a.jpg,ball,NaN,1,0.085,10,10,20,30, | size_m is 'NaN'",
        "images/a.jpg,ball,0.22,0,0.085,10,10,20,30, | distance_m is '0'",
        "images/a.jpg,ball,0.22,1,85,10,10,20,30, | focal_length_m is '85'",
        "images/a.jpg,ball,0.22,1,,10,10,20,30, | focal_length_m is '', expected metres, or a"
            + " photo",
        "images/a.jpg,ball,0.22,1,0.085,50,10,20,30, | the patch is 20 x 30 at (50, 10), expected"
            + " one",
        "images/a.jpg,ball,0.22,1,0.085,10,10,0,30, | patch_width is '0'",
        "images/a.jpg,ball,0.22,1,0.085,10,10,2.5,30, | patch_width is '2.5'",
        "images/a.jpg,ball,0.22,1,0.085,-1,10,20,30, | patch_x is '-1'",
        "images/a.jpg,ball,0.22,1,0.085,,,,, | one box for the image and object in coco.json",
        "images/a.jpg,ball,0.22,1,0.085,10,10,20,30,no.png | mask is 'no.png'",
        "images/a.jpg,ball,0.22 | the row has 3 cells, expected 10",
      })
  void reportsErrorsWithTheirRow(String row, String words) throws IOException {
    List<String> problems = problems(row);
    assertEquals(1, problems.size(), problems.toString());
    assertTrue(problems.get(0).startsWith(folder.resolve("dataset.csv") + ":2:"), problems.get(0));
    assertTrue(problems.get(0).contains(words), problems.get(0));
  }

  @Test
  void reportsEveryProblemOfEveryRow() throws IOException {
    List<String> problems =
        problems(
            "images/none.jpg,ball,0,1,0.085,10,10,20,30,",
            ROW,
            "images/a.jpg,ball,0.22,-1,0.085,100,10,20,30,");
    assertEquals(5, problems.size(), problems.toString());
    assertTrue(problems.get(0).contains("dataset.csv:2:"), problems.toString());
    assertTrue(problems.get(2).contains("line 3 has it"), problems.toString());
    assertTrue(problems.get(4).contains("dataset.csv:4:"), problems.toString());
  }

  @Test
  void reportsMissingFilesInOneLine() throws IOException {
    Files.delete(folder.resolve("camera.json"));
    List<String> problems = problems(ROW);
    assertEquals(1, problems.size());
    assertTrue(problems.get(0).contains("camera.json: no such file"), problems.get(0));
  }

  @Test
  void reportsMissingColumnsAndRowsInOneLine() throws IOException {
    table(HEADER.replace("size_m", "size"), ROW);
    assertTrue(
        DatasetReader.read(folder).problems().get(0).contains("expected image,object,size_m,"));
    table(HEADER);
    String problem = DatasetReader.read(folder).problems().get(0);
    assertTrue(problem.contains("no rows"), problem);
  }

  private LabelledPhoto sample(String row) throws IOException {
    table(HEADER, row);
    DatasetReader.Reading reading = DatasetReader.read(folder);
    assertEquals(List.of(), reading.problems());
    return reading.dataset().orElseThrow().samples().get(0);
  }

  private List<String> problems(String... rows) throws IOException {
    table(HEADER, rows);
    DatasetReader.Reading reading = DatasetReader.read(folder);
    assertTrue(reading.dataset().isEmpty());
    return reading.problems();
  }

  private void table(String header, String... rows) throws IOException {
    Files.writeString(
        folder.resolve("dataset.csv"), header + "\n" + String.join("\n", rows) + "\n");
  }
}
